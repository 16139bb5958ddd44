#pragma once

#include <filesystem>

namespace nacre {

// The part of a picture's pixels that are transparent, with an alpha below a tenth; 0 where it has no alpha.
// A UserError of the picture itself.
double load_clear_part(const std::filesystem::path& file);

}  // namespace nacre
