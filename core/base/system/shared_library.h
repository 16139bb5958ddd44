#pragma once

#include <filesystem>

namespace nacre {

// Where the program that runs was started from.
std::filesystem::path program_folder();

// The address of a name in a shared library, which stays loaded. A name without a folder is looked up in the
// run path. A std::runtime_error with the loader's reason.
void* symbol_of_library(const std::filesystem::path& library, const char* name);

}  // namespace nacre
