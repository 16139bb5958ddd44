#pragma once

#include "core/image/raster.h"

namespace nacre {

// The raster as a square of at most limits::raster_max texels a side, with black beside it where it was none,
// averaged down where it was larger; `notes` say what was changed.
Raster made_square(const Raster& raster, PictureNotes& notes);

}  // namespace nacre
