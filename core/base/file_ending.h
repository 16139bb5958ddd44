// The last part of a file's name, which tells its format.
#pragma once

#include <filesystem>
#include <string>

namespace nacre {

// With its dot, in small letters: ".exr" of "Sky.EXR". Empty where the name has none.
std::string ending_of(const std::filesystem::path& file);

}  // namespace nacre
