#pragma once

#include "core/image/raster.h"

namespace nacre {

// The raster with `side` pixels a side, no more than it has: each new pixel is the mean over its area,
// so that the mean of the whole stays.
Raster area_average(const Raster& raster, int side);

}  // namespace nacre
