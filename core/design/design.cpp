#include "core/design/design.h"

namespace nacre {

// Copies of a design share their rasters: the same pointer needs no look at the pixels.
bool Picture::operator==(const Picture& other) const {
    if (file != other.file) return false;
    if (raster == other.raster) return true;
    return raster && other.raster && *raster == *other.raster;
}

}  // namespace nacre
