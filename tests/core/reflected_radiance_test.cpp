// The integral of what a surface reflects of a picture, against closed forms and against itself.
#include <doctest/doctest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "core/bake/bake.h"
#include "core/light/procedural.h"
#include "core/verify/reference.h"
#include "core/verify/reflected_radiance.h"
#include "tests/core/designs.h"

using namespace nacre;
using namespace nacre::test;

namespace {

// Leans by 50 degrees toward +x of the environment's frame.
glm::dmat3 leaning_frame() {
    const double t = 50 * std::numbers::pi / 180;
    return {{std::cos(t), 0, -std::sin(t)}, {0, 1, 0}, {std::sin(t), 0, std::cos(t)}};
}

std::shared_ptr<const Environment> environment(const char* name) {
    return make_environment(name, *procedural_environment(name, 256));
}

}  // namespace

TEST_SUITE_BEGIN("reflected radiance");

TEST_CASE("a matt surface under 1 + x sends out (1 + 2/3 x.n) of its albedo") {
    Design matt = design_of(GgxLobe{0.5, 0.5});
    matt.diffuse = LambertianDiffuse{.kd = 1, .ks = 0, .albedo = {0.8, 0.4, 0.2}};
    LatLong picture{256, 128, {}};
    for (int row = 0; row < 128; ++row)
        for (int column = 0; column < 256; ++column)
            picture.radiance.emplace_back(1 +
                                          lat_long_direction({(column + 0.5) / 256, (row + 0.5) / 128}).x);
    const RadianceIntegral integral(bake(matt), make_environment("linear", picture), 2);
    const glm::dmat3 frame = leaning_frame();
    const dvec3 value = integral(frame, glm::normalize(dvec3(0.3, 0.2, 0.7)));
    const double expected = 1 + 2.0 / 3 * frame[2].x;
    CHECK(value.x == doctest::Approx(0.8 * expected).epsilon(1e-3));
    CHECK(value.z == doctest::Approx(0.2 * expected).epsilon(1e-3));
}

TEST_CASE("in a furnace it is the albedo of the reference") {
    for (const Lobe& lobe :
         {Lobe(BeckmannLobe{0.02, 0.02}), Lobe(GaussianLobe{0.1, 1}), Lobe(InverseGaussianLobe{0.5})}) {
        const Design design = design_of(lobe);
        const RadianceIntegral integral(bake(design), environment("furnace"), 2);
        const Reference reference(design);
        for (const double c : {0.95, 0.4, 0.1}) {
            CAPTURE(c);
            const dvec3 k{0.8 * std::sqrt(1 - c * c), 0.6 * std::sqrt(1 - c * c), c};
            const dvec3 expected = reference.design_albedo(reference.albedo(k));
            CHECK(integral(leaning_frame(), k).y == doctest::Approx(expected.y).epsilon(3e-3));
        }
    }
}

TEST_CASE("finer points change it by little, under a small sun and for a needle") {
    for (const Lobe& lobe : {Lobe(BeckmannLobe{0.01, 0.01}), Lobe(GaussianLobe{0.1, limits::infinity})}) {
        const auto tables = bake(design_of(lobe));
        for (const char* name : {"studio", "sky"}) {
            CAPTURE(name);
            const auto light = environment(name);
            for (const double c : {0.9, 0.15}) {
                const dvec3 k{0.6 * std::sqrt(1 - c * c), 0.8 * std::sqrt(1 - c * c), c};
                const double coarse = RadianceIntegral(tables, light, 1)(leaning_frame(), k).y;
                const double fine = RadianceIntegral(tables, light, 2)(leaning_frame(), k).y;
                CHECK(coarse == doctest::Approx(fine).epsilon(4e-3));
            }
        }
    }
}

TEST_SUITE_END();
