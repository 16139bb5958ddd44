// What the designer remembers from one run to the next about how it is used; nothing of a design.
#pragma once

#include <filesystem>
#include <string>

#include "app/designer/habits.h"
#include "app/designer/layout.h"
#include "app/designer/private_json_file.h"

namespace nacre {

struct Settings {
    Layout layout;
    Habits habits;
    bool system_dialogs = true;            // zenity or kdialog, where there is one
    std::filesystem::path design_folder;   // of the last design that was opened or saved
    std::filesystem::path picture_folder;  // that F12 writes to; empty until it was chosen
    std::filesystem::path export_folder;   // of the last export
    bool operator==(const Settings&) const = default;
};

// As settings.json holds them. What is wrong with the text is a UserError of `name`.
Settings parse_settings(const std::string& text, const std::string& name);
std::string settings_text(const Settings& settings);

class SettingsFile {
  public:
    // Reads settings.json of the folder; where there is none yet, `first` holds. An empty folder: nothing is
    // read or kept.
    explicit SettingsFile(const std::filesystem::path& folder, Settings first = {});

    Settings values;
    bool is_first_run() const { return first_run_; }  // no settings were there

    // Writes what changed since. A failure is told once by problem() and tried again with the next change.
    void keep();
    const std::string& problem() const { return file_.problem(); }

  private:
    PrivateJsonFile file_;
    Settings kept_;
    bool first_run_ = true;
};

}  // namespace nacre
