// Shows a folder in the desktop's file manager, by xdg-open: started with a list of arguments, without a
// shell, and asked now and then how it went.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "app/designer/user_folders.h"
#include "core/base/system/released_process.h"

namespace nacre {

// xdg-open in PATH; empty without it, and without a display.
std::filesystem::path find_folder_opener(const EnvironmentVariables& environment);

class FolderOpener {
  public:
    // `program`: as find_folder_opener() gives it.
    void open(const std::filesystem::path& folder, const std::filesystem::path& program);

    // Why the folder could not be shown, in one line; empty when it was, or while it is being opened. Never
    // waits.
    const std::string& problem();
    void forget_problem() { problem_.clear(); }

  private:
    std::filesystem::path folder_;
    std::optional<ReleasedProcess> process_;
    std::string problem_;
};

}  // namespace nacre
