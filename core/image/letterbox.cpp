#include "core/image/letterbox.h"

#include <algorithm>

namespace nacre {

Raster letterboxed(const Raster& raster) {
    const int side = std::max(raster.width, raster.height);
    const int top = (side - raster.height) / 2, left = (side - raster.width) / 2;
    Raster square{side, side, std::vector<float>(static_cast<std::size_t>(side) * side)};
    for (int row = 0; row < raster.height; ++row) {
        const auto from = raster.values.begin() + static_cast<std::ptrdiff_t>(row) * raster.width;
        std::copy(from, from + raster.width,
                  square.values.begin() + static_cast<std::ptrdiff_t>(row + top) * side + left);
    }
    return square;
}

}  // namespace nacre
