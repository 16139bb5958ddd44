// H, N and g of a painted layer against the plain sum over its texels.
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
    double mass = 0;            // of the values
    dvec3 mean{0};              // of value h
    std::vector<double> areas;  // of value (h.k)+, for each view k
};

inline TexelSums texel_sums(const Raster& raster, const glm::dmat3& frame, const std::vector<dvec3>& views) {
    TexelSums sums;
    sums.areas.resize(views.size());
    for (int row = 0; row < raster.height; ++row)
        for (int column = 0; column < raster.width; ++column) {
            const glm::dvec2 point = texel_point(raster.width, row, column);
            if (!holds_facets(point)) continue;
            const double value =
                static_cast<double>(raster.values[static_cast<std::size_t>(row * raster.width + column)]);
            const dvec3 h = frame * disk_direction(point);
            sums.mass += value;
            sums.mean += value * h;
            for (std::size_t i = 0; i < views.size(); ++i)
                sums.areas[i] += value * std::max(glm::dot(h, views[i]), 0.0);
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
    CHECK(glm::length(p.mean() - sums.mean / sums.mass) < 1e-12);
    CHECK(std::abs(p.mean_cosine() - sums.mean.z / sums.mass) < 1e-12);
    for (std::size_t i = 0; i < views.size(); ++i)
        CHECK(p.projected_area(views[i]) == doctest::Approx(sums.areas[i] / sums.mass).epsilon(1e-12));
}

}  // namespace nacre::test
