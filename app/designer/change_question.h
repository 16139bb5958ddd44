// The question about a design's file that is not as it was when it was read or written here.
#pragma once

#include <filesystem>
#include <optional>

namespace nacre {

enum class ChangeAnswer { reload, save_as, overwrite, keep_mine, cancel };

// Draws it. `gone`: the file is not there any more. `saving`: it is about to be written, else it was noticed.
std::optional<ChangeAnswer> ask_about_change(const std::filesystem::path& file, bool gone, bool saving);

}  // namespace nacre
