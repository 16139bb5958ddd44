// Reference::albedo() where p lies in a small part of its picture.
#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "core/bake/albedo.h"
#include "core/model/disk.h"
#include "core/model/polar_angles.h"
#include "core/verify/reference.h"
#include "tests/core/designs.h"

using namespace nacre;
using namespace nacre::test;

namespace {

struct Texel {
    int column, row;
};

struct FewTexels {
    int side;
    std::vector<Texel> lit;

    Picture picture() const {
        auto raster = std::make_shared<Raster>();
        raster->width = raster->height = side;
        raster->values.assign(static_cast<std::size_t>(side * side), 0.0f);
        for (const Texel& texel : lit)
            raster->values[static_cast<std::size_t>(texel.row * side + texel.column)] = 1;
        return {.file = {}, .raster = std::move(raster)};
    }
};

// A tent is so many places wide.
constexpr int places = 400;

// The midpoint rule over the texels' tents, none of which meets another one. Solid angles are twice areas.
double albedo_by_midpoints(const Reference& reference, const FewTexels& texels, dvec3 k) {
    const FacetAlbedo integrand{reference.shading(), k, reference.projected_area(k), reference.channels()};
    auto area = [&](dvec3 k2) { return reference.projected_area(k2); };
    const double cell = 4.0 / texels.side / places;
    double sum = 0;
    for (const Texel& texel : texels.lit)
        for (int row = 0; row < places; ++row)
            for (int column = 0; column < places; ++column) {
                const dvec2 at = dvec2((2 * texel.column + 1.0) / texels.side - 1,
                                       1 - (2 * texel.row + 1.0) / texels.side) +
                                 cell * dvec2(column + 0.5 - places / 2, row + 0.5 - places / 2);
                if (glm::dot(at, at) >= 1) continue;
                const dvec3 h = disk_direction(at);
                const double p = reference.shading().density(h);
                if (p > 0) sum += integrand(h, area)[0] * p * 2 * cell * cell;
            }
    return sum;
}

// Half of the directions within 3 degrees of the horizon.
void check_directions(const Reference& reference, const FewTexels& texels, int count) {
    for (int i = 0; i < count; ++i) {
        const double part = std::fmod(0.25 + i * 0.7548776662466927, 1.0);
        const double theta = i % 2 == 1 ? 87 + 2.999 * part : 87 * part;
        CAPTURE(theta);
        const dvec3 k = polar_direction(theta, 50 + 137.5 * i);
        CHECK(std::fabs(reference.albedo(k)[0] - albedo_by_midpoints(reference, texels, k)) < 2e-5);
    }
}

void check_painted(const FewTexels& texels, int count) {
    const Reference reference(design_of(PaintedLobe{texels.picture()}));
    check_directions(reference, texels, count);
}

const FewTexels one_upright{64, {{32, 32}}};

}  // namespace

TEST_CASE("exact R of a single texel is that of its own facets, however few of them an integral meets") {
    const Reference reference(design_of(PaintedLobe{one_upright.picture()}));
    for (const double theta : {60.0, 85.0, 87.0, 88.34, 88.543, 89.0, 89.7}) {
        CAPTURE(theta);
        const dvec3 k = polar_direction(theta, 17);
        CHECK(reference.albedo(k)[0] ==
              doctest::Approx(albedo_by_midpoints(reference, one_upright, k)).epsilon(1e-4));
    }
}

TEST_CASE("exact R of one or two texels keeps its bound on directions that no bound was chosen by") {
    SUBCASE("upright") { check_painted(one_upright, 24); }
    SUBCASE("of few large ones") { check_painted({5, {{2, 2}}}, 8); }
    SUBCASE("apart, on no box's border") { check_painted({100, {{50, 50}, {70, 30}}}, 8); }
    SUBCASE("nearly touching, of many") { check_painted({512, {{256, 256}, {259, 253}}}, 8); }
    SUBCASE("that the rim cuts") { check_painted({64, {{0, 32}}}, 8); }
}

TEST_CASE("exact R of a lobe that one texel is left of keeps its bound") {
    Design design = design_of(GgxLobe{0.4, 0.4});
    design.distribution.layers.front().modulation = Modulation{one_upright.picture(), 1};
    check_directions(Reference(design), one_upright, 8);
}
