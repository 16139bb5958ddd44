#include "core/paint/balance.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "core/base/error.h"
#include "core/model/facet_distribution.h"
#include "core/paint/painted_layer.h"
#include "core/paint/raster_texels.h"
#include "tests/core/designs.h"
#include "tests/core/property.h"
#include "tests/core/random_directions.h"

using namespace nacre;

namespace {

double off_n(const Distribution& distribution) {
    const dvec3 mean = FacetDistribution(distribution).mean();
    return std::hypot(mean.x, mean.y);
}

// A wide highlight off the middle and a narrow one on the other side.
Picture lopsided(int side) {
    return test::picture_of(side, [](double x, double y) {
        const auto spot = [&](double a, double b, double width) {
            return std::exp(-((x - a) * (x - a) + (y - b) * (y - b)) / (width * width));
        };
        return spot(0.2, 0.1, 0.3) + 0.5 * spot(-0.5, -0.3, 0.08);
    });
}

const Raster& raster_of(const Distribution& distribution, std::size_t layer = 0) {
    return *std::get<PaintedLobe>(distribution.layers[layer].lobe).image.raster;
}

}  // namespace

TEST_CASE("balance: a picture becomes itself times an exponential of the normal, and its mean normal is n") {
    const Design before = test::design_of(PaintedLobe{lopsided(512)}, 15, 40, 25);
    REQUIRE(off_n(before.distribution) > 0.1);
    const Distribution after = balanced(before.distribution);
    CHECK(off_n(after) < 1e-9);
    // ln(p'/p) is linear in h along the surface: three texels tell it, all others agree.
    const glm::dmat3 frame = layer_frame(before.distribution.layers[0]);
    const auto change = [&](int row, int column) {
        const auto index = static_cast<std::size_t>(row * 512 + column);
        return std::log(static_cast<double>(raster_of(after).values[index]) /
                        static_cast<double>(raster_of(before.distribution).values[index]));
    };
    const auto normal = [&](int row, int column) {
        return frame * disk_direction(texel_point(512, row, column));
    };
    const dvec3 a = normal(250, 250), b = normal(250, 350), c = normal(150, 250);
    const glm::dmat2 edges(dvec2(b.x - a.x, c.x - a.x), dvec2(b.y - a.y, c.y - a.y));
    const dvec2 lambda =
        glm::inverse(edges) * dvec2(change(250, 350) - change(250, 250), change(150, 250) - change(250, 250));
    CHECK(glm::length(lambda) > 0.5);
    for (int row = 130; row < 380; row += 13)
        for (int column = 130; column < 380; column += 17) {
            const dvec3 h = normal(row, column);
            CHECK(change(row, column) - change(250, 250) ==
                  doctest::Approx(glm::dot(lambda, dvec2(h.x - a.x, h.y - a.y))).epsilon(1e-5));
        }
}

TEST_CASE("balance: no other change of the texels that brings the mean normal to n is as small") {
    const Design before = test::design_of(PaintedLobe{lopsided(512)});
    const Distribution after = balanced(before.distribution);
    const Raster &p = raster_of(before.distribution), &q = raster_of(after);
    const double mass_p = raster_mass(p), mass_q = raster_mass(q);
    // Relative entropy of q' = q + t d from p, d a change that keeps mass and mean normal: its derivative in
    // every such d is 0 at the minimum, so that ln(q/p) is orthogonal to d.
    Random random(11);
    for (int trial = 0; trial < 20; ++trial) {
        // Five texels always have a combination that keeps three sums.
        dvec3 row[4];
        double logarithm[4], change[4];
        for (int i = 0; i < 4; ++i) {
            const int y = 140 + static_cast<int>(230 * uniform_random(random));
            const int x = 140 + static_cast<int>(230 * uniform_random(random));
            const auto index = static_cast<std::size_t>(y * 512 + x);
            const dvec3 h = disk_direction(texel_point(512, y, x));
            row[i] = {1, h.x, h.y};
            logarithm[i] = std::log(static_cast<double>(q.values[index]) / mass_q /
                                    (static_cast<double>(p.values[index]) / mass_p));
        }
        const dvec3 first = glm::inverse(glm::dmat3(row[0], row[1], row[2])) * -row[3];
        for (int i = 0; i < 3; ++i) change[i] = first[i];
        change[3] = 1;
        double derivative = 0, size = 0;
        for (int i = 0; i < 4; ++i) derivative += change[i] * logarithm[i], size += std::abs(change[i]);
        CHECK(std::abs(derivative) < 1e-5 * size);
    }
}

TEST_CASE("balance: a lobe alone leans back to n and keeps its form, whatever it is") {
    const std::vector<Lobe> lobes = {GaussianLobe{0.3, 0.1}, GaussianLobe{0.2, limits::infinity},
                                     GgxLobe{0.2, 0.4},      BeckmannLobe{0.1, 0.1},
                                     UniformLobe{},          CurveLobe{{{0, 1}, {30, 0.2}, {50, 0}}}};
    for (const Lobe& lobe : lobes) {
        const Design before = test::design_of(lobe, 25, 70, 10);
        const Distribution after = balanced(before.distribution);
        CHECK(off_n(after) < 1e-9);
        CHECK(after.layers[0].lobe == lobe);
        CHECK(after.layers[0].weight == doctest::Approx(1));
        CHECK(after.layers[0].tilt < 1e-6);
    }
}

TEST_CASE("balance: a wide lobe on n with a leaning one share what has to change") {
    Design design = test::design_of(GaussianLobe{0.4, 0.4});
    design = test::with_layer(design, GaussianLobe{0.3, 0.3}, 0.25, 30, 0);
    const Distribution after = balanced(design.distribution);
    CHECK(off_n(after) < 1e-9);
    CHECK(after.layers[0].weight + after.layers[1].weight == doctest::Approx(1.25));
    CHECK(after.layers[1].weight < 0.25);
    CHECK(after.layers[1].tilt < 30);
    CHECK(std::abs(after.layers[0].azimuth) == doctest::Approx(180));  // leans the other way
    CHECK(after.layers[0].lobe == design.distribution.layers[0].lobe);
}

TEST_CASE("balance: of lobes and pictures together, and again it changes nothing") {
    Design design = test::design_of(GgxLobe{0.3, 0.3}, 12, 200);
    design = test::with_layer(design, PaintedLobe{lopsided(64)}, 0.6, 10, 30);
    design.distribution.layers[1].modulation =
        Modulation{test::picture_of(32, [](double x, double y) { return 0.5 + 0.4 * x * y; }), 0.7};
    design = test::with_layer(design, UniformLobe{UniformDomain::sphere}, 0.05);
    Layer out;
    out.enabled = false;
    out.tilt = 60;
    design.distribution.layers.push_back(out);
    const Distribution after = balanced(design.distribution);
    CHECK(off_n(after) < 1e-9);
    CHECK(after.layers[3] == out);
    CHECK(after.layers[2].lobe == design.distribution.layers[2].lobe);
    CHECK(balanced(after) == after);
}

TEST_CASE("balance: what leans to one side is left as it is, with the reason") {
    const auto dab = test::picture_of(
        512, [](double x, double y) { return (x - 0.5) * (x - 0.5) + y * y < 0.01 ? 1.0 : 0.0; });
    const Design painted = test::design_of(PaintedLobe{dab});
    CHECK_THROWS_WITH_AS(balanced(painted.distribution),
                         ": balance: all facets are tilted to one side; Straighten turns them instead",
                         UserError);
    const Design mirror =
        test::with_layer(test::design_of(GaussianLobe{0.001, 0.001}), GaussianLobe{0.3, 0.3}, 0.5, 50);
    CHECK_THROWS_WITH_AS(
        balanced(mirror.distribution),
        ": balance: next to nothing would be left of layer 2; Straighten turns all layers instead",
        UserError);
}

TEST_CASE("balance: of random designs each is balanced to 1e-9 or refused") {
    int done = 0;
    CHECK(test::holds(
        "balance",
        [&] {
            const Design design = test::physical_design();
            try {
                const Distribution after = balanced(design.distribution);
                RC_ASSERT(off_n(after) < 1e-9);
                ++done;
                for (const Layer& layer : after.layers) {
                    RC_ASSERT(std::isfinite(layer.weight));
                    RC_ASSERT(layer.weight <= limits::weight_max);
                }
            } catch (const UserError&) {
            }
        },
        40));
    CHECK(done > 10);
}
