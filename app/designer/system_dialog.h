// File dialogs of the desktop, as programs of their own: zenity or kdialog, started with a list of arguments
// and asked from frame to frame whether there is an answer.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/designer/user_folders.h"
#include "core/base/system/child_process.h"
#include "ui/dialogs.h"

namespace nacre {

struct FileQuestion {
    ui::FileDialog::Purpose purpose = ui::FileDialog::Purpose::open;
    std::string title = {};
    std::filesystem::path folder = {};  // where it begins
    std::string name = {};              // proposed to save under
    std::string kind = {};              // what is asked for: "Nacre design"
    // ".svg", ".csv", in lower case; other files are not shown. Empty: all files.
    std::vector<std::string> extensions = {};
};

struct DialogProgram {
    enum class Kind { zenity, kdialog };
    Kind kind = Kind::zenity;
    std::filesystem::path file;  // absolute
};

// kdialog under KDE, else zenity, else whichever of them PATH has; none without a display.
std::optional<DialogProgram> find_dialog_program(const EnvironmentVariables& environment);

// What it is started with, the program's own name first.
std::vector<std::string> dialog_arguments(const DialogProgram& program, const FileQuestion& question);

class SystemDialog {
  public:
    SystemDialog(const DialogProgram& program, const FileQuestion& question);  // its end closes the dialog

    enum class State { open, accepted, cancelled, failed };
    State poll();  // never waits

    const std::filesystem::path& chosen() const { return chosen_; }

  private:
    State finished(ChildProcess::Ended ended);

    State state_ = State::open;
    ChildProcess child_;
    std::filesystem::path chosen_;
};

}  // namespace nacre
