// Where a user's own things are kept, by the XDG Base Directory Specification 0.8.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace nacre {

// An empty path: nothing of that kind is read or kept. The folders need not exist.
struct UserFolders {
    std::filesystem::path config = {};  // settings
    std::filesystem::path state = {};   // recent files, unsaved work
    std::filesystem::path data = {};    // presets of one's own
    std::filesystem::path home = {};    // where file dialogs begin
};

using EnvironmentVariables = std::function<const char*(const char* variable)>;  // null where it is not set

// XDG_CONFIG_HOME/nacre and so on; where such a variable is not set, or not absolute, the usual place below
// HOME. Empty paths without either.
UserFolders user_folders(const EnvironmentVariables& environment);

}  // namespace nacre
