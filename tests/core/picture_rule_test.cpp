// Reference::albedo() where p lies in a small part of its picture.
#include <doctest/doctest.h>

#include <cmath>

#include "core/bake/albedo.h"
#include "core/model/disk.h"
#include "core/model/polar_angles.h"
#include "core/verify/reference.h"
#include "tests/core/designs.h"

using namespace nacre;
using namespace nacre::test;

namespace {

constexpr int side = 64;

Design one_texel() {
    auto raster = std::make_shared<Raster>();
    raster->width = raster->height = side;
    raster->values.assign(std::size_t{side} * side, 0.0f);
    raster->values[std::size_t{side} * side / 2 + side / 2] = 1;
    Design design;
    design.distribution.layers.front().lobe = PaintedLobe{{.file = {}, .raster = std::move(raster)}};
    return design;
}

// The midpoint rule over the part of the disk that holds facets. Solid angles are twice areas there.
double albedo_by_midpoints(const Reference& reference, dvec3 k) {
    constexpr int count = 800;
    constexpr double low = -4.0 / side, cell = -2 * low / count;
    const FacetAlbedo integrand{reference.shading(), k, reference.projected_area(k), reference.channels()};
    auto area = [&](dvec3 k2) { return reference.projected_area(k2); };
    double sum = 0;
    for (int row = 0; row < count; ++row)
        for (int column = 0; column < count; ++column) {
            const dvec3 h = disk_direction({low + (column + 0.5) * cell, low + (row + 0.5) * cell});
            const double p = reference.shading().density(h);
            if (p > 0) sum += integrand(h, area)[0] * p * 2 * cell * cell;
        }
    return sum;
}

}  // namespace

TEST_CASE("exact R of a single texel is that of its own facets, however few of them an integral meets") {
    const Reference reference(one_texel());
    for (const double theta : {60.0, 85.0, 87.0, 88.34, 89.0, 89.7}) {
        CAPTURE(theta);
        const dvec3 k = polar_direction(theta, 17);
        CHECK(reference.albedo(k)[0] == doctest::Approx(albedo_by_midpoints(reference, k)).epsilon(1e-3));
    }
}

TEST_CASE("exact R of a single texel keeps its bounds on directions that no bound was chosen by") {
    const Reference reference(one_texel());
    for (int i = 0; i < 24; ++i) {
        const double part = std::fmod(0.25 + i * 0.7548776662466927, 1.0);
        const bool grazes = i % 2 == 1;
        const double theta = grazes ? 87 + 2.999 * part : 87 * part;
        CAPTURE(theta);
        const dvec3 k = polar_direction(theta, 50 + 137.5 * i);
        CHECK(std::fabs(reference.albedo(k)[0] - albedo_by_midpoints(reference, k)) < (grazes ? 5e-3 : 5e-5));
    }
}
