// The chi-square test that `check` makes of samples: it passes what is right and finds what is not.
#include <doctest/doctest.h>

#include "core/bake/bake.h"
#include "core/bake/brdf.h"
#include "core/verify/sampling_density.h"
#include "tests/core/designs.h"
#include "tests/core/random_directions.h"

using namespace nacre;
using namespace nacre::test;

namespace {

constexpr double most_surprise = 6;
constexpr int few = 3;  // directions

std::vector<Diffuse> diffuse_models() {
    return {NoDiffuse{}, LambertianDiffuse{}, CoupledDiffuse{}, MetalDiffuse{}, FacetDiffuse{}};
}

// Brdf's sampler but for how often it draws the cosine.
std::function<DirectionSource(dvec3)> drawing_the_cosine(const Tables& tables, double probability) {
    return [&tables, probability](dvec3 k1) -> DirectionSource {
        return [&tables, probability, k1](Random& random) -> std::optional<dvec3> {
            if (uniform_random(random) < probability) return cosine_sample(random);
            const dvec3 h = tables.distribution->sample_visible(k1, random);
            const dvec3 k2 = 2 * glm::dot(k1, h) * h - k1;
            return k2.z > 0 ? std::optional<dvec3>(k2) : std::nullopt;
        };
    };
}

double surprise_of(const Design& design) {
    return measure_sampling_density(bake(design), {}, {}, few).surprise;
}

}  // namespace

TEST_SUITE_BEGIN("sampling density");

#ifdef NACRE_SANITIZED  // ten times as slow
constexpr bool slow = true;
#else
constexpr bool slow = false;
#endif

TEST_CASE("samples are as dense as the pdf with every diffuse model" * doctest::skip(slow)) {
    for (Diffuse diffuse : diffuse_models()) {
        CAPTURE(diffuse.index());
        for (Design design :
             {design_of(GgxLobe{0.01, 0.1}, 30, 20),
              with_layer(design_of(GaussianLobe{0.1, limits::infinity}), InverseGaussianLobe{0.5}, 0.5)}) {
            design.diffuse = diffuse;
            CHECK(surprise_of(design) < most_surprise);
        }
    }
}

TEST_CASE("samples of painted and modulated p are as dense as the pdf") {
    Design painted = design_of(
        PaintedLobe{picture_of(48, [](double x, double y) { return x > 0.1 && y < 0.3 ? 1 + x : 0.01; })},
        20);
    painted.diffuse = CoupledDiffuse{};
    CHECK(surprise_of(painted) < most_surprise);
    Design modulated = with_layer(design_of(GaussianLobe{0.4, 0.2}, 15, 70), UniformLobe{}, 0.3);
    modulated.distribution.layers[0].modulation =
        Modulation{picture_of(32, [](double x, double y) { return x * y > 0 ? 1 : 0.1; }), 0.8};
    modulated.diffuse = LambertianDiffuse{};
    CHECK(surprise_of(modulated) < most_surprise);
}

TEST_CASE("a diffuse term that is drawn a fifth too seldom or too often is found, whatever the model") {
    for (const Diffuse& diffuse : diffuse_models()) {
        if (std::holds_alternative<NoDiffuse>(diffuse)) continue;
        CAPTURE(diffuse.index());
        for (Design design : {design_of(GgxLobe{0.05, 0.05}, 20), design_of(UniformLobe{})}) {
            design.diffuse = diffuse;
            const auto tables = bake(design);
            auto surprise = [&](double probability) {
                return measure_sampling_density(tables, {}, drawing_the_cosine(*tables, probability), few)
                    .surprise;
            };
            CHECK(surprise(0.5) < most_surprise);
            CHECK(surprise(0.4) > most_surprise);
            CHECK(surprise(0.6) > most_surprise);
        }
    }
}

TEST_CASE("facets drawn without regard to what hides them are found") {
    const auto tables = bake(design_of(GgxLobe{0.5, 0.5}));
    const Tables& all = *tables;
    const auto by_mass = [&all](dvec3 k1) -> DirectionSource {
        return [&all, k1](Random& random) -> std::optional<dvec3> {
            const dvec3 h = all.distribution->sample_visible({0, 0, 1}, random);
            const dvec3 k2 = 2 * glm::dot(k1, h) * h - k1;
            return k2.z > 0 ? std::optional<dvec3>(k2) : std::nullopt;
        };
    };
    CHECK(measure_sampling_density(tables, {}, by_mass, few).surprise > 100);
}

TEST_SUITE_END();
