#pragma once

#include <filesystem>

#include "core/image/picture.h"

namespace nacre {

// A PictureProblem where the picture is not a lat-long one.
LatLong read_environment(const std::filesystem::path& file, PictureNotes& notes);

}  // namespace nacre
