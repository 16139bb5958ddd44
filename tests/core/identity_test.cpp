// What holds for every p: RapidCheck draws the designs.
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <cmath>

#include "core/bake/bake.h"
#include "core/bake/brdf.h"
#include "core/verify/reference.h"
#include "tests/core/designs.h"
#include "tests/core/property.h"
#include "tests/core/random_design.h"
#include "tests/core/random_directions.h"

using namespace nacre;
using namespace nacre::test;

namespace {

bool same_bits(dvec3 a, dvec3 b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

bool sound(dvec3 value) {
    for (int i = 0; i < 3; ++i)
        if (!(value[i] >= 0) || !std::isfinite(value[i])) return false;
    return true;
}

}  // namespace

TEST_SUITE_BEGIN("identities");

TEST_CASE("g(k) - g(-k) = k.H and g = k . grad g for every p") {
    CHECK(holds(
        "difference",
        [] {
            const FacetDistribution p(physical_design().distribution);
            Random random(*rc::gen::arbitrary<unsigned>());
            for (int i = 0; i < 8; ++i) {
                const dvec3 k = random_direction(random);
                const Area front = p.area(k);
                RC_ASSERT(std::fabs(front.g - p.area(-k).g - glm::dot(k, p.mean())) < 2e-6);
                RC_ASSERT(std::fabs(front.g - glm::dot(k, front.gradient)) < 2e-6);
            }
        },
        60));
}

TEST_CASE("the gradient of g is the slope of g") {
    for (const Design& design :
         {design_of(GaussianLobe{0.1, 1}, 20, 30, 10), design_of(GgxLobe{0.3, 0.05}, 50),
          design_of(BeckmannLobe{2, 0.2}, 10), design_of(InverseGaussianLobe{0.5}),
          design_of(CurveLobe{{{20, 0}, {25, 1}, {30, 0}}}, 15), design_of(UniformLobe{}, 100)}) {
        Random random(9);
        Layer layer = design.distribution.layers.front();
        const auto lobe = make_lobe(layer);
        for (int i = 0; i < 6; ++i) {
            const dvec3 k = random_direction(random);
            const double h = 1e-5;
            for (int axis = 0; axis < 3; ++axis) {
                dvec3 step{0};
                step[axis] = h;
                // g is homogeneous: evaluate on unit vectors and scale back.
                auto g = [&](dvec3 v) { return glm::length(v) * lobe->area(glm::normalize(v)).g; };
                const double slope = (g(k + step) - g(k - step)) / (2 * h);
                CHECK(lobe->area(k).gradient[axis] ==
                      doctest::Approx(slope).epsilon(1e-5).scale(lobe->mass()));
            }
        }
    }
}

TEST_CASE("eval is reciprocal to the bit, finite and never negative") {
    CHECK(holds(
        "reciprocity",
        [] {
            const Brdf brdf(bake(physical_design(), {.quality = Quality::draft}));
            Random random(*rc::gen::arbitrary<unsigned>());
            for (int i = 0; i < 200; ++i) {
                const dvec3 a = random_direction(random), b = i % 10 ? random_direction(random) : a;
                for (const Term term : {Term::specular, Term::diffuse, Term::total}) {
                    const dvec3 value = brdf.evaluate(a, b, term);
                    RC_ASSERT(sound(value));
                    RC_ASSERT(same_bits(value, brdf.evaluate(b, a, term)));
                }
            }
        },
        60));
}

TEST_CASE("R never exceeds 1 under clamp, for any p") {
    CHECK(holds(
        "energy",
        [] {
            Design design = physical_design();
            design.shadowing.clamp = true;
            design.fresnel = NoFresnel{};
            const Reference reference(design);
            Random random(*rc::gen::arbitrary<unsigned>());
            const dvec3 k = random_direction(random);
            const double g = reference.projected_area(k);
            // The bake's rule on the exact g of the viewer and a table for the rest.
            const auto tables = bake(design, {.quality = Quality::draft, .albedo = true});
            const AlbedoQuadrature rule(reference.distribution(), tables->shading, 0, 1e-4);
            RC_ASSERT(rule(k, g)[0] < 1 + 2e-3);
        },
        40));
}

TEST_SUITE_END();
