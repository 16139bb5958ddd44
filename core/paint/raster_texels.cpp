#include "core/paint/raster_texels.h"

namespace nacre {

double raster_value(const std::vector<float>& values, int side, glm::dvec2 disk_at) {
    const double column = (disk_at.x + 1) / 2 * side - 0.5, row = (1 - disk_at.y) / 2 * side - 0.5;
    const double j = std::floor(column), i = std::floor(row);
    const double s = column - j, t = row - i;
    const auto texel = [&](double r, double c) {
        if (r < 0 || c < 0 || r >= side || c >= side) return 0.0;
        return static_cast<double>(values[static_cast<std::size_t>(r) * static_cast<std::size_t>(side) +
                                          static_cast<std::size_t>(c)]);
    };
    return (texel(i, j) * (1 - s) + texel(i, j + 1) * s) * (1 - t) +
           (texel(i + 1, j) * (1 - s) + texel(i + 1, j + 1) * s) * t;
}

}  // namespace nacre
