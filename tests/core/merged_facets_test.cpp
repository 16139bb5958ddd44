// Many facets as one set.
#include <doctest/doctest.h>

#include <cmath>
#include <ctime>

#include "core/bake/bake.h"
#include "core/model/merged_facets.h"
#include "core/verify/close_albedo.h"
#include "core/verify/physics_check.h"
#include "tests/core/big_design.h"
#include "tests/core/random_directions.h"

using namespace nacre;
using namespace nacre::test;

TEST_SUITE_BEGIN("merged facets");

// Of g, relatively.
constexpr double merging_tolerance = 5e-6;

TEST_CASE("merged facets hold the same p: mass, mean, density, samples and g") {
    const Design design = with_layer(big_design(3, 64), GgxLobe{0.2, 0.2}, 0.5);
    const FacetDistribution apart(design.distribution);
    const auto merged = merge_facets(design.distribution, apart);
    CHECK(merged->lobes().size() == 2);
    CHECK(glm::length(merged->mean() - apart.mean()) < 1e-12);
    Random random(3);
    for (int i = 0; i < 200; ++i) {
        const dvec3 k = random_direction(random);
        CHECK(merged->density(k) == doctest::Approx(apart.density(k)).epsilon(1e-12));
        const Area area = merged->area(k), exact = apart.area(k);
        CHECK(std::fabs(area.g - exact.g) < merging_tolerance * exact.g);
        CHECK(area.g == doctest::Approx(glm::dot(k, area.gradient)).epsilon(1e-9));
        CHECK(glm::length(area.gradient - exact.gradient) < 5e-4);
        CHECK(glm::dot(merged->sample_visible(k, random), k) > 0);
    }
    CHECK(merging_error(apart, *merged) < merging_tolerance);
}

TEST_CASE("merging resolves facets that crowd about one direction") {
    Design design = design_of(PaintedLobe{picture_of(
        256, [](double x, double y) { return std::exp(-(std::pow(x - 0.2, 2) + y * y) / 1e-4); })});
    design = with_layer(design, PaintedLobe{picture_of(64, [](double, double) { return 1.0; })}, 0.1, 20);
    const FacetDistribution apart(design.distribution);
    CHECK(merging_error(apart, *merge_facets(design.distribution, apart)) < merging_tolerance);
}

TEST_CASE("R over merged facets is that of all facets") {
    const Design design = big_design(3, 32);
    REQUIRE(count_facets(design.distribution) == 3 * 256 * 256);
    const Reference reference(design);
    const dvec3 k = polar(0.5, 1);
    const AlbedoValues close = CloseAlbedo(reference, 1e-5)(k), exact = reference.albedo(k);
    CHECK(std::fabs(close[0] - exact[0]) < 2e-5);
    CHECK(std::fabs(close[1] - exact[1]) < 2e-5);
}

// Not run with the others: it takes half a minute of processor time.
TEST_CASE("16 painted layers of 1024 x 1024 with 16 modulations bake in 20 s and are checked in 60 s" *
          doctest::skip()) {
    const Design design = big_design(16, 1024);
    const auto seconds_since = [](std::clock_t begin) {
        return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    };
    std::clock_t begin = std::clock();
    const auto tables = bake(design, {.albedo = true});
    const double baked = seconds_since(begin);
    MESSAGE("bake: " << baked << " s of processor time, claims " << tables->errors.area.worst << " and "
                     << tables->errors.albedo.worst);
    CHECK(baked < 20);
    begin = std::clock();
    const PhysicsReport report = check_physics(design);
    const double checked = seconds_since(begin);
    MESSAGE("check: " << checked << " s of processor time");
    CHECK(checked < 60);
    for (const PhysicsCheck& check : report.checks) {
        CAPTURE(check.name);
        CAPTURE(check.figure);
        CHECK(check.verdict != Verdict::fail);
    }
}

TEST_SUITE_END();
