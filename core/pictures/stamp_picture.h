#pragma once

#include <filesystem>

#include "core/image/raster.h"

namespace nacre {

// See load_stamp(). A PictureProblem where it cannot be read.
Raster read_stamp(const std::filesystem::path& file, PictureNotes& notes);

}  // namespace nacre
