// After an export: what was written, and what to do next with it. A panel in a corner that takes nothing from
// the rest of the window but Enter and Escape, which close it.
#pragma once

#include <string>
#include <vector>

namespace nacre::ui {

struct ExportReport {
    std::string title;   // "Exported satin.glsl"
    std::string folder;  // that the files are in
    std::vector<std::string> files = {};
    std::vector<std::string> notes = {};  // what is to be known of the files: a sentence each
    std::vector<std::string> steps;
    std::string problem = {};  // why the folder could not be shown, or empty
};

enum class ReportAnswer { none, open_folder, closed };

ReportAnswer export_report(const ExportReport& report);

}  // namespace nacre::ui
