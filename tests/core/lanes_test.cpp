// The shared mathematics for many directions at once is the same as for one, on every kind of processor that
// this one can stand in for.
#include <doctest/doctest.h>
#include <hwy/targets.h>

#include <cmath>

#include "core/bake/albedo.h"
#include "core/bake/bake.h"
#include "core/bake/brdf_pairs.h"
#include "core/model/float_shading.h"
#include "tests/core/designs.h"
#include "tests/core/property.h"
#include "tests/core/random_directions.h"

using namespace nacre;
using namespace nacre::test;
using glm::vec3;

namespace {

// Calls visit() once for each kind of processor, as if this were one.
template <class Visit>
void for_each_target(const Visit& visit) {
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
        hwy::SetSupportedTargetsForTest(target);
        hwy::GetChosenTarget().Update(target);
        visit();
    }
    hwy::SetSupportedTargetsForTest(0);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

struct Pairs {
    std::vector<vec3> k1, k2;
};

// Grazing ones, equal ones, mirrored ones, at n, below the horizon; their number is a multiple of no vector.
Pairs pairs_of(Random& random) {
    Pairs pairs;
    for (int i = 0; i < 203; ++i) {
        const dvec3 k1 = random_direction(random);
        dvec3 k2 = i % 7 == 1 ? k1 : i % 7 == 2 ? dvec3{-k1.x, -k1.y, k1.z} : random_direction(random);
        if (i % 11 == 3) k2.z = -k2.z;
        if (i % 13 == 4) k2 = {0, 0, 1};
        if (i % 17 == 5) k2 = {0.6, 0.8, 0};
        pairs.k1.emplace_back(k1);
        pairs.k2.emplace_back(k2);
    }
    return pairs;
}

// Within so many roundings of float, on the scale of the larger; the exponential of a large number loses
// more.
bool close(vec3 a, vec3 b) {
    for (int i = 0; i < 3; ++i)
        if (!(std::fabs(a[i] - b[i]) <= 2e-5F * std::fmax(std::fabs(a[i]), std::fabs(b[i])) + 1e-30F))
            return false;
    return true;
}

}  // namespace

TEST_SUITE_BEGIN("lanes");

TEST_CASE("the BRDF of pairs is that of each of them, and reciprocal to the last bit") {
    for_each_target([] {
        CHECK(holds(
            "pairs",
            [] {
                const auto tables = bake(physical_design(), {.quality = Quality::draft});
                const Shading<float> shading = in_float(tables->shading);
                Random random(*rc::gen::arbitrary<unsigned>());
                const Pairs pairs = pairs_of(random);
                std::vector<vec3> rho(pairs.k1.size()), swapped(pairs.k1.size());
                evaluate_pairs(shading, pairs.k1, pairs.k2, rho);
                evaluate_pairs(shading, pairs.k2, pairs.k1, swapped);
                for (std::size_t i = 0; i < rho.size(); ++i) {
                    RC_ASSERT(close(rho[i], shading.brdf(pairs.k1[i], pairs.k2[i])));
                    RC_ASSERT(rho[i] == swapped[i]);
                }
            },
            25));
    });
}

TEST_CASE("R summed over facets side by side is the sum over each of them") {
    for_each_target([] {
        CHECK(holds(
            "facets",
            [] {
                const auto tables = bake(physical_design(), {.quality = Quality::draft, .albedo = true});
                const Shading<double>& shading = tables->shading;
                Random random(*rc::gen::arbitrary<unsigned>());
                const dvec3 k1 = random_direction(random);
                const double g1 = tables->distribution->projected_area(k1);
                const int channels = tables->needs.fresnel_tables;
                const auto area = [&](dvec3 k) { return shading.projected_area(k, shading.table_spot(k)); };
                const FacetAlbedo one{shading, k1, g1, channels};
                WeightedDirections facets;
                LayerAlbedo sum{};
                for (int i = 0; i < 101; ++i) {
                    const Facet facet{random_direction(random), 0.01 * uniform_random(random)};
                    facets.add(facet.h, facet.mass);
                    const LayerAlbedo values = one(facet.h, area);
                    for (std::size_t c = 0; c < sum.size(); ++c) sum[c] += facet.mass * values[c];
                }
                const LayerAlbedo together = sum_albedo(shading, k1, g1, channels, facets);
                for (std::size_t c = 0; c < sum.size(); ++c)
                    RC_ASSERT(std::fabs(together[c] - sum[c]) <= 1e-5 * sum[c]);
            },
            25));
    });
}

TEST_CASE("no pairs and no facets are none") {
    const auto tables = bake(design_of(GaussianLobe{0.1, 1.0}), {.quality = Quality::draft});
    evaluate_pairs(in_float(tables->shading), {}, {}, {});
    CHECK(sum_albedo(tables->shading, {0, 0, 1}, 1, 0, {})[0] == 0);
}

TEST_CASE("the density at many directions is that at each of them") {
    const auto property = [] {
        const FacetDistribution p(physical_design().distribution);
        Random random(*rc::gen::arbitrary<std::uint64_t>());
        std::vector<double> x, y, z;
        for (int i = 0; i < 61; ++i) {
            dvec3 h = i == 0 ? dvec3{0, 0, 1} : random_direction(random);
            if (i % 9 == 4) h.z = -h.z;
            x.push_back(h.x), y.push_back(h.y), z.push_back(h.z);
        }
        const DirectionColumns columns{x.data(), y.data(), z.data(), x.size()};
        for_each_target([&] {
            std::vector<double> values(x.size(), -1);
            p.densities(columns, values.data());
            for (std::size_t i = 0; i < x.size(); ++i) {
                const double one = p.density({x[i], y[i], z[i]});
                RC_ASSERT(std::fabs(values[i] - one) <= 1e-11 * one + 1e-300);
            }
        });
    };
    CHECK(holds("densities side by side", property, 200));
}

TEST_SUITE_END();
