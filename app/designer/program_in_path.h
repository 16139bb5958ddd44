// Programs of the desktop that Nacre starts.
#pragma once

#include <filesystem>

#include "app/designer/user_folders.h"

namespace nacre {

// Whether windows can be shown.
bool has_display(const EnvironmentVariables& environment);

// Absolute; empty where PATH has no such program.
std::filesystem::path program_in_path(const EnvironmentVariables& environment, const char* name);

}  // namespace nacre
