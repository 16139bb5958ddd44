// File extensions.
#pragma once

#include <filesystem>
#include <string>

namespace nacre {

// With its dot, in lower case: ".exr" of "Sky.EXR". Empty where the name has none.
std::string extension_of(const std::filesystem::path& file);

}  // namespace nacre
