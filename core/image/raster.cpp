#include "core/image/raster.h"

#include <algorithm>

namespace nacre {

// Copies of a design share their rasters: the same pointer needs no look at the pixels.
bool Picture::operator==(const Picture& other) const {
    if (file != other.file) return false;
    if (raster == other.raster) return true;
    return raster && other.raster && *raster == *other.raster;
}

bool is_black(const Picture& picture) {
    const std::vector<float>& values = picture.raster->values;
    return std::none_of(values.begin(), values.end(), [](float value) { return value > 0; });
}

}  // namespace nacre
