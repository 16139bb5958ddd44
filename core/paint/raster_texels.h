// The texels of a painted layer as normals of its own frame.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/image/raster.h"
#include "core/model/disk_texels.h"

namespace nacre {

inline constexpr int painted_side = 512;  // texels a side of a layer that is painted on

// Texels whose middle lies inside the horizon hold facets. Those just beyond it are painted too, as the
// picture would go on there, though p takes nothing from them.
inline bool holds_facets(glm::dvec2 at) { return glm::dot(at, at) < 1; }
inline bool is_painted(int side, glm::dvec2 at) {
    const double outermost = 1 + 3.0 / side;
    return glm::dot(at, at) < outermost * outermost;
}

// Calls visit(index, h) for every texel within `reach` (radians) of the unit vector `middle`, some farther
// ones among them. The disk shortens no way by more than it does at the pole, where a radian is 1/sqrt(2),
// and lengthens none beyond 1.
template <class Visit>
void visit_texels(int side, glm::dvec3 middle, double reach, const Visit& visit) {
    const glm::dvec2 at = disk_point(middle);
    const auto column = [&](double x) { return static_cast<int>(std::floor((x + 1) / 2 * side)); };
    const auto row = [&](double y) { return static_cast<int>(std::floor((1 - y) / 2 * side)); };
    const double spread = reach + 3.0 / side;
    const int left = std::max(column(at.x - spread), 0), right = std::min(column(at.x + spread), side - 1);
    const int top = std::max(row(at.y + spread), 0), bottom = std::min(row(at.y - spread), side - 1);
    for (int i = top; i <= bottom; ++i)
        for (int j = left; j <= right; ++j) {
            const glm::dvec2 point = texel_point(side, i, j);
            if (is_painted(side, point))
                visit(static_cast<std::size_t>(i) * static_cast<std::size_t>(side) +
                          static_cast<std::size_t>(j),
                      disk_direction(point));
        }
}

// Bilinear between texel middles, 0 beyond the outermost ones.
double raster_value(const std::vector<float>& values, int side, glm::dvec2 disk_at);

}  // namespace nacre
