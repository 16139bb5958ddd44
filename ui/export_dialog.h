// What to export, with each format's options, and the work's progress.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "ui/dialogs.h"

namespace nacre::ui {

struct ExportChoice {
    std::string title;
    std::string about;
    std::string holds;        // how it has what the design has; empty where there is nothing to say
    bool refuses = false;     // the design
    bool is_picture = false;  // has a size; else an error that its tables are made for
    bool has_names = false;   // that begin with a prefix
    bool has_error = false;   // that its size follows
};

// Open for as long as export_dialog() is called.
struct ExportDialog {
    std::vector<ExportChoice> formats;
    std::size_t chosen = 0;
    double tolerance = 1e-3;             // of g relative, of R absolute
    double width = 1024, height = 1024;  // pixels
    double error = 0.01;                 // part of the light that may be misplaced
    std::string prefix = "nacre";
    std::string prefix_problem;  // empty: nothing is wrong with it
};

DialogAnswer export_dialog(ExportDialog& dialog);

// Returns whether it is to be stopped. `done` from 0 to 1.
bool progress_dialog(const char* title, const std::string& text, double done);

}  // namespace nacre::ui
