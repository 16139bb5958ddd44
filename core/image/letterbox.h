#pragma once

#include "core/image/raster.h"

namespace nacre {

// The raster padded with 0 to a square, centred and
// not resampled. Of an odd number of added rows or
// columns the larger half is below or at the right.
Raster letterboxed(const Raster& raster);

}  // namespace nacre
