// Samples of retro-reflective designs, and what rests on them.
#include <doctest/doctest.h>

#include "core/bake/bake.h"
#include "core/bake/brdf.h"
#include "core/bake/brdf_samples.h"
#include "core/light/procedural.h"
#include "core/verify/physics_check.h"
#include "core/verify/reflected_radiance.h"
#include "core/verify/sampling_density.h"
#include "tests/core/retro_designs.h"

using namespace nacre;
using namespace nacre::test;

TEST_SUITE_BEGIN("retro sampling");

TEST_CASE("samples weigh what their density says, one by one and side by side") {
    const Brdf brdf(bake(lopsided(0.4), {.quality = Quality::draft}));
    Random random(5);
    const std::vector<dvec3> k1(400, probes[1]);
    std::vector<BrdfSample> many(k1.size());
    sample_directions(brdf, k1, random, many);
    for (int i = 0; i < 400; ++i)
        if (const auto sample = brdf.sample(probes[1], random)) many.push_back(*sample);
    int back = 0, forward = 0;
    for (const BrdfSample& sample : many) {
        if (!(sample.pdf > 0)) continue;
        const dvec3 rho = brdf.evaluate(probes[1], sample.k2);
        CHECK(sample.pdf == doctest::Approx(brdf.pdf(probes[1], sample.k2)).epsilon(1e-9));
        for (int c = 0; c < 3; ++c)
            CHECK(sample.weight[c] == doctest::Approx(rho[c] * sample.k2.z / sample.pdf).epsilon(1e-9));
        (glm::dot(sample.k2, probes[1]) > glm::dot(turned(sample.k2), probes[1]) ? back : forward) += 1;
    }
    CHECK(back > 100);
    CHECK(forward > 100);
}

TEST_CASE("samples are as dense as the pdf, and one way drawn too seldom is found") {
    const auto tables = bake(lopsided(0.4)), without = bake(lopsided(0));
    CHECK(measure_sampling_density(tables, {}, {}, 3).surprise < 6);
    Design bare = lopsided(1);
    bare.diffuse = NoDiffuse{};
    CHECK(measure_sampling_density(bake(bare), {}, {}, 3).surprise < 6);
    const Brdf mirror(without);
    const auto mirrored_alone = [&](dvec3 k1) -> DirectionSource {
        return [&mirror, k1](Random& random) -> std::optional<dvec3> {
            const dvec3 k2 = mirror.draw(k1, random);
            return k2.z > 0 ? std::optional<dvec3>(k2) : std::nullopt;
        };
    };
    CHECK(measure_sampling_density(tables, {}, mirrored_alone, 3).surprise > 6);
}

TEST_CASE("in a furnace it reflects its albedo, by light and by the facets of every way") {
    Design narrow = design_of(GaussianLobe{0.05, 0.1}, 20, 40);
    narrow.retro.weight = 0.7;
    const auto tables = bake(narrow, {.albedo = true});
    const auto light = make_environment("furnace", *procedural_environment("furnace", 256));
    const RadianceIntegral integral(tables, light, 2);
    for (const dvec3 k : {probes[1], probes[2], probes[4]})
        CHECK(integral(glm::dmat3(1), k).y == doctest::Approx(Brdf(tables).albedo(k).y).epsilon(3e-3));
}

TEST_CASE("the physics of a retro-reflective design holds, samples and pdf included") {
    for (const auto& check : check_physics(lopsided(0.7)).checks)
        CHECK_MESSAGE(check.verdict != Verdict::fail,
                      check.name << " " << check.figure << " " << check.bound);
}

TEST_SUITE_END();
