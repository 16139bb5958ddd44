#include "core/bake/baker.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "tests/core/designs.h"
#include "tests/core/random_directions.h"

using namespace nacre;
using namespace nacre::test;

namespace {

using std::numbers::pi;

Design coupled(Design design) {
    design.diffuse = CoupledDiffuse{};
    return design;
}

Design two_layers() { return coupled(with_layer(design_of(GaussianLobe{0.1, 0.5}), GgxLobe{0.4, 0.4}, 0.5)); }

Design painted(double dab) {
    return design_of(PaintedLobe{picture_of(512, [&](double x, double y) {
        const double away = std::hypot(x - 0.3, y + 0.2);
        return std::exp(-4 * (x * x + 2 * y * y)) + (away < 0.03 ? dab : 0.0);
    })});
}

void check_same(const Tables& a, const Tables& b) {
    CHECK(a.data == b.data);
    CHECK(a.shading.surface.coupling == b.shading.surface.coupling);
    CHECK(a.errors.area.worst == b.errors.area.worst);
    CHECK(a.errors.albedo.worst == b.errors.albedo.worst);
}

// Largest difference of g between the tables and p itself, as area_error() measures it.
double worst_error(const Tables& tables) {
    Random random(5);
    double worst = 0;
    for (int i = 0; i < 2000; ++i) {
        const dvec3 k = random_direction(random);
        worst = std::fmax(worst, area_error(tables.shading, k, tables.distribution->projected_area(k)));
    }
    return worst;
}

}  // namespace

TEST_SUITE_BEGIN("baker");

TEST_CASE("a colour bakes nothing, and the tables are those of a new bake") {
    Baker baker;
    Design design = two_layers();
    const auto first = baker.bake(design);
    CHECK(baker.area_origin() == TableOrigin::rebuilt);
    CHECK(baker.albedo_origin() == TableOrigin::rebuilt);
    CHECK(first->bake_seconds > 0);
    std::get<CoupledDiffuse>(design.diffuse).albedo = {0.9, 0.1, 0.2};
    std::get<SchlickFresnel>(design.fresnel).f0 = {0.5, 0.4, 0.3};
    design.distribution.layers[0].name = "renamed";
    const auto kept = baker.bake(design);
    CHECK(baker.area_origin() == TableOrigin::reused);
    CHECK(baker.albedo_origin() == TableOrigin::reused);
    CHECK(kept->bake_seconds == first->bake_seconds);
    check_same(*kept, *bake(design));
}

TEST_CASE("another masking keeps g and bakes R") {
    Baker baker;
    Design design = two_layers();
    baker.bake(design);
    design.shadowing.model = CorrelatedMasking{};
    const auto again = baker.bake(design);
    CHECK(baker.area_origin() == TableOrigin::reused);
    CHECK(baker.albedo_origin() == TableOrigin::rebuilt);
    check_same(*again, *bake(design));
}

TEST_CASE("a final bake does not depend on what was baked before") {
    Baker baker;
    for (const Design& design : {two_layers(), coupled(painted(0)), coupled(painted(1)), two_layers()})
        for (const Quality quality : {Quality::draft, Quality::final}) {
            const auto tables = baker.bake(design, {.quality = quality});
            if (quality == Quality::final) check_same(*tables, *bake(design));
        }
}

TEST_CASE("a draft sums g again after a change of weights, and says how far it is off") {
    Baker baker;
    Design design = two_layers();
    const BakeOptions draft{.quality = Quality::draft};
    baker.bake(design, draft);
    for (const double weight : {0.55, 0.6, 0.7}) {
        design.distribution.layers[1].weight = weight;
        const auto tables = baker.bake(design, draft);
        CHECK(baker.area_origin() == TableOrigin::updated);
        CHECK(worst_error(*tables) < 1.25 * tables->errors.area.worst);
        CHECK(worst_error(*tables) < 0.01);
    }
    design.distribution.layers[1].lobe = GgxLobe{0.01, 0.01};
    baker.bake(design, draft);
    CHECK(baker.area_origin() == TableOrigin::rebuilt);
}

TEST_CASE("a draft adds a dab to g, and the lobe is the same to the bit as one made anew") {
    Baker baker;
    const BakeOptions draft{.quality = Quality::draft};
    baker.bake(painted(0.5), draft);
    const Design dabbed = painted(2);
    const auto tables = baker.bake(dabbed, draft);
    CHECK(baker.area_origin() == TableOrigin::updated);
    CHECK(worst_error(*tables) < 1.25 * tables->errors.area.worst);
    const FacetDistribution anew(dabbed.distribution);
    Random random(6);
    for (int i = 0; i < 100; ++i) {
        const dvec3 k = random_direction(random);
        CHECK(tables->distribution->projected_area(k) == anew.projected_area(k));
    }
}

TEST_CASE("a stopped bake leaves the baker as it was") {
    Baker baker;
    Design design = two_layers();
    baker.bake(design);
    Design other = design;
    other.distribution.layers[0].lobe = GaussianLobe{0.3, 0.2};
    std::stop_source stop;
    stop.request_stop();
    CHECK_THROWS_AS(baker.bake(other, {}, stop.get_token()), BakeCancelled);
    baker.bake(design);
    CHECK(baker.area_origin() == TableOrigin::reused);
}

TEST_SUITE_END();

TEST_SUITE_BEGIN("tolerance");

TEST_CASE("600 nodes hold g of one lobe within 5e-4, 1e-4 in the mean, whatever its width") {
    auto check = [](const Lobe& lobe, const TableSize& size) {
        const auto tables = bake(design_of(lobe), {.size = size});
        CHECK(tables->size.w * tables->size.psi <= 600);
        CHECK(tables->errors.area.worst <= 5e-4);
        CHECK(tables->errors.area.root_mean_square <= 1e-4);
        CHECK(worst_error(*tables) <= 5e-4);
    };
    for (const double width : {1e-3, 0.01, 0.1, 1.0, 10.0}) {
        CAPTURE(width);
        for (const Lobe& lobe : {Lobe(GaussianLobe{width, width}), Lobe(GgxLobe{width, width}),
                                 Lobe(InverseGaussianLobe{width})})
            check(lobe, {513, 1, 9, 1});
        for (const Lobe& lobe : {Lobe(GaussianLobe{width, 0.999}), Lobe(GgxLobe{width, 0.3})}) {
            if (std::holds_alternative<GaussianLobe>(lobe) && width > 1) continue;
            check(lobe, {65, 9, 9, 9});
        }
    }
}

TEST_CASE("the size follows the tolerance") {
    std::size_t before = 0;
    for (const double tolerance : {1e-2, 1e-3, 2e-4}) {
        const auto tables = bake(two_layers(), {.tolerance = tolerance});
        CHECK(tables->errors.area.worst <= tolerance);
        CHECK(tables->errors.albedo.worst <= tolerance);
        CHECK(tables->table_floats() > before);
        CHECK(tables->table_floats() <= 16384);
        before = tables->table_floats();
    }
}

TEST_CASE("a white furnace closes over the float tables") {
    for (Design design : {two_layers(), design_of(GaussianLobe{0.01, 1}), painted(1)}) {
        design.fresnel = NoFresnel{};
        design.diffuse = CoupledDiffuse{dvec3{1}};
        const auto tables = bake(design, {.quality = Quality::draft});
        const Shading<double>& shading = tables->shading;
        // (1/pi) integral of total albedo cos dk; the diffuse part integrates to (1 - R) only if c is that of
        // the very interpolant. A midpoint rule in theta and azimuth.
        auto furnace = [&](int polar, int azimuths) {
            double outgoing = 0, share = 0;
            for (int i = 0; i < polar; ++i)
                for (int j = 0; j < azimuths; ++j) {
                    const double u = (i + 0.5) / polar, theta = 0.5 * pi * u;
                    const double s = std::sin(theta), c = std::cos(theta);
                    const double phi = 2 * pi * (j + 0.5) / azimuths;
                    const dvec3 k{s * std::cos(phi), s * std::sin(phi), c};
                    const double weight = pi / polar / azimuths * s * c;
                    const auto spot = shading.direction(k);
                    outgoing += weight * spot.R.x;
                    share += weight * shading.diffuse_share(spot).x;
                }
            // Of light 1 from everywhere: R + c (1 - R) integral of (1 - R) cos, averaged.
            return outgoing + share * (shading.surface.coupling.x * pi * share);
        };
        CHECK(std::fabs(furnace(2000, 1500) - 1) < 1e-6);
    }
}

TEST_SUITE_END();
