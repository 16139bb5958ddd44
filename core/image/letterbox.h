#pragma once

#include "core/image/raster.h"

namespace nacre {

// The raster in the middle of a square whose sides are its longer one, 0 beside it: no value changes, and
// nothing is stretched. Where an odd number of rows or columns is added the larger half stands below or
// right.
Raster letterboxed(const Raster& raster);

}  // namespace nacre
