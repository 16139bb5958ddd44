#include "core/image/lat_long.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace nacre {

using std::numbers::pi;

glm::dvec3 lat_long_direction(glm::dvec2 place) {
    const double t = pi * place.y, p = 2 * pi * (place.x - 0.5);
    return {std::sin(t) * std::sin(p), std::cos(t), -std::sin(t) * std::cos(p)};
}

glm::dvec2 lat_long_place(glm::dvec3 direction) {
    const double level = std::hypot(direction.x, direction.z);
    const double p = level > 0 ? std::atan2(direction.x, -direction.z) : 0;
    return {0.5 + p / (2 * pi), std::atan2(level, direction.y) / pi};
}

double texel_solid_angle(const LatLong& picture, int row) {
    const double top = pi * row / picture.height, bottom = pi * (row + 1) / picture.height;
    return 2 * pi / picture.width * (std::cos(top) - std::cos(bottom));
}

glm::dvec3 radiance_at(const LatLong& picture, glm::dvec2 place) {
    const double x = place.x * picture.width - 0.5;
    const double y = std::clamp(place.y * picture.height - 0.5, 0.0, picture.height - 1.0);
    const double column = std::floor(x), row = std::floor(y);
    const double s = x - column, t = y - row;
    const auto texel = [&](double c, double r) {
        const int i = (static_cast<int>(c) + picture.width) % picture.width;
        const int j = std::min(static_cast<int>(r), picture.height - 1);
        return glm::dvec3(picture.radiance[static_cast<std::size_t>(j * picture.width + i)]);
    };
    const glm::dvec3 top = texel(column, row) * (1 - s) + texel(column + 1, row) * s;
    const glm::dvec3 bottom = texel(column, row + 1) * (1 - s) + texel(column + 1, row + 1) * s;
    return top * (1 - t) + bottom * t;
}

}  // namespace nacre
