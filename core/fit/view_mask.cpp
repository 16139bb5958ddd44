#include "core/fit/view_mask.h"

#include <algorithm>
#include <cmath>

namespace nacre {

namespace {

constexpr int side = 64;

}  // namespace

dvec3 texel_direction(int column, int row, int texels) {
    constexpr double radius_max = 0.99;  // the horizon itself has no P(k)/(n.k)
    dvec2 at = 2.0 * dvec2(column, row) / (texels - 1.0) - 1.0;
    const double radius = glm::length(at);
    if (radius > radius_max) at *= radius_max / radius;
    const double square = glm::dot(at, at);
    return {at * (2 / (1 + square)), (1 - square) / (1 + square)};
}

dvec2 texel_place(dvec3 k, int texels) {
    const double scale = 1 / (1 + std::max(k.z, 0.0));
    return glm::clamp((dvec2(k) * scale + 1.0) * (0.5 * (texels - 1)), 0.0, texels - 1.0);
}

double ViewMask::visibility_part(const Tables& tables, dvec3 k) {
    const Shading<double>& shading = tables.shading;
    const double g = shading.projected_area(k, shading.table_spot(k));
    return g > 0 ? shading.masking(Shading<double>::known_direction(k, g, dvec3{0})) / k.z : 0;
}

ViewMask::ViewMask(const Tables& tables) {
    part_.reserve(std::size_t{side} * side);
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column)
            part_.push_back(visibility_part(tables, texel_direction(column, row, side)));
}

ViewMask::Part ViewMask::look_up(dvec3 k) const {
    const dvec2 at = texel_place(k, side);
    const int column = std::min(static_cast<int>(at.x), side - 2);
    const int row = std::min(static_cast<int>(at.y), side - 2);
    const double* corner = &part_[static_cast<std::size_t>(row * side + column)];
    const double x = at.x - column, y = at.y - row;
    const double low = corner[0] + x * (corner[1] - corner[0]);
    const double high = corner[side] + x * (corner[side + 1] - corner[side]);
    const double by_x = (1 - y) * (corner[1] - corner[0]) + y * (corner[side + 1] - corner[side]);
    return {low + y * (high - low), {by_x, high - low}};
}

MaskValue ViewMask::operator()(dvec3 k, double blur) const {
    const Part part = look_up(k);
    const double root = std::sqrt(k.z * k.z + blur * blur);
    const double cosine = 0.5 * (k.z + root);
    const double half = 0.5 * (side - 1), size = 1 / (1 + std::max(k.z, 0.0));
    const dvec2 by_place = part.by_place * (half * size);
    const double by_size = k.z > 0 ? -glm::dot(by_place, dvec2(k)) * size : 0;
    return {part.value * cosine,
            {by_place * cosine, by_size * cosine + part.value * 0.5 * (1 + k.z / root)},
            part.value * 0.5 * blur / root};
}

}  // namespace nacre
