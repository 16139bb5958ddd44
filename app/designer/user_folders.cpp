#include "app/designer/user_folders.h"

namespace nacre {
namespace {

namespace fs = std::filesystem;

// The specification has relative paths ignored.
fs::path absolute_path(const EnvironmentVariables& environment, const char* variable) {
    const char* value = environment(variable);
    const fs::path path = value != nullptr ? value : "";
    return path.is_absolute() ? path : fs::path();
}

}  // namespace

UserFolders user_folders(const EnvironmentVariables& environment) {
    const fs::path home = absolute_path(environment, "HOME");
    const auto folder = [&](const char* variable, const char* below_home) {
        fs::path base = absolute_path(environment, variable);
        if (base.empty() && !home.empty()) base = home / below_home;
        return base.empty() ? base : base / "nacre";
    };
    return {.config = folder("XDG_CONFIG_HOME", ".config"),
            .state = folder("XDG_STATE_HOME", ".local/state"),
            .data = folder("XDG_DATA_HOME", ".local/share"),
            .home = home};
}

}  // namespace nacre
