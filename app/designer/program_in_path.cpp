#include "app/designer/program_in_path.h"

#include <algorithm>
#include <string_view>

#include "core/base/system/child_process.h"

namespace nacre {
namespace {

bool is_set(const EnvironmentVariables& environment, const char* variable) {
    const char* value = environment(variable);
    return value != nullptr && *value != '\0';
}

}  // namespace

bool has_display(const EnvironmentVariables& environment) {
    return is_set(environment, "DISPLAY") || is_set(environment, "WAYLAND_DISPLAY");
}

std::filesystem::path program_in_path(const EnvironmentVariables& environment, const char* name) {
    const char* path = environment("PATH");
    for (std::string_view rest = path != nullptr ? path : ""; !rest.empty();) {
        const std::size_t end = std::min(rest.find(':'), rest.size());
        const std::filesystem::path file = std::filesystem::path(rest.substr(0, end)) / name;
        rest.remove_prefix(std::min(end + 1, rest.size()));
        if (file.is_absolute() && is_executable(file)) return file;
    }
    return {};
}

}  // namespace nacre
