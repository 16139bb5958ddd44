// H, N and g of a painted layer against plain sums over small parts of its texels.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/model/facet_distribution.h"
#include "core/paint/raster_texels.h"
#include "tests/core/random_directions.h"

namespace nacre::test {

struct TexelSums {
    double mass = 0;            // of the values, times solid angle
    dvec3 mean{0};              // of the same times h
    std::vector<double> areas;  // of the same times (h.k)+, for each view k
};

// A texel off the disk is read as the nearest on it, several as near as their mean.
inline double texel_read(const Raster& raster, int row, int column) {
    const auto value = [&](int r, int c) {
        return static_cast<double>(raster.values[static_cast<std::size_t>(r * raster.width + c)]);
    };
    if (holds_facets(texel_point(raster.width, row, column))) return value(row, column);
    double sum = 0;
    int nearest = 9, count = 0;
    for (int r = std::max(row - 1, 0); r <= std::min(row + 1, raster.height - 1); ++r)
        for (int c = std::max(column - 1, 0); c <= std::min(column + 1, raster.width - 1); ++c) {
            const int distance = (r - row) * (r - row) + (c - column) * (c - column);
            if (!holds_facets(texel_point(raster.width, r, c)) || distance > nearest) continue;
            if (distance < nearest) sum = count = 0;
            nearest = distance;
            sum += value(r, c);
            ++count;
        }
    return count > 0 ? sum / count : 0;
}

inline TexelSums texel_sums(const Raster& raster, const glm::dmat3& frame, const std::vector<dvec3>& views) {
    constexpr int parts = 4;  // of a texel, along each side; 2e-5 of them are miscounted at the rim
    const int side = raster.width;
    std::vector<double> read;
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column) read.push_back(texel_read(raster, row, column));
    const auto value = [&](int row, int column) {
        row = std::clamp(row, 0, side - 1), column = std::clamp(column, 0, side - 1);
        return read[static_cast<std::size_t>(row * side + column)];
    };
    TexelSums sums;
    sums.areas.resize(views.size());
    for (int row = 0; row < parts * side; ++row)
        for (int column = 0; column < parts * side; ++column) {
            const glm::dvec2 point = texel_point(parts * side, row, column);
            const double y = (row + 0.5) / parts - 0.5, x = (column + 0.5) / parts - 0.5;
            const int i = static_cast<int>(std::floor(y)), j = static_cast<int>(std::floor(x));
            const double a = value(i, j), b = value(i, j + 1), c = value(i + 1, j), d = value(i + 1, j + 1);
            if (!holds_facets(point) || a + b + c + d == 0) continue;
            const double top = a * (j + 1 - x) + b * (x - j), bottom = c * (j + 1 - x) + d * (x - j);
            const double mass = (top * (i + 1 - y) + bottom * (y - i)) * texel_solid_angle(parts * side);
            const dvec3 h = frame * disk_direction(point);
            sums.mass += mass;
            sums.mean += mass * h;
            for (std::size_t k = 0; k < views.size(); ++k)
                sums.areas[k] += mass * std::max(glm::dot(h, views[k]), 0.0);
        }
    return sums;
}

// `p` is of this layer alone.
inline void check_texel_sums(const FacetDistribution& p, const Layer& layer) {
    Random random(8);
    std::vector<dvec3> views;
    for (int i = 0; i < 6; ++i) views.push_back(random_direction(random));
    const TexelSums sums =
        texel_sums(*std::get<PaintedLobe>(layer.lobe).image.raster, layer_frame(layer), views);
    CHECK(glm::length(p.mean() - sums.mean / sums.mass) < 3e-5);
    CHECK(std::abs(p.mean_cosine() - sums.mean.z / sums.mass) < 3e-5);
    for (std::size_t i = 0; i < views.size(); ++i)
        CHECK(p.projected_area(views[i]) == doctest::Approx(sums.areas[i] / sums.mass).epsilon(5e-5));
}

}  // namespace nacre::test
