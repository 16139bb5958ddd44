// What matt facets cost beside Lambert's law for the whole surface: evaluation, and the bake.
#include <fmt/core.h>

#include "core/bake/brdf_pairs.h"
#include "core/model/float_shading.h"
#include "tests/bench/bench_designs.h"
#include "tests/bench/subjects.h"
#include "tests/core/random_directions.h"

namespace nacre::bench {
namespace {

Design with(Design design, const Diffuse& diffuse) {
    design.diffuse = diffuse;
    return design;
}

void add_evaluation_of(Report& report, const char* name, const Design& design) {
    const std::string what = fmt::format("BRDF, batch: {} with matt facets against Lambertian", name);
    add_benchmark(what, 301, [=, &report](benchmark::State& state) {
        constexpr std::size_t count = 4096;
        const auto matt = bake(with(design, FacetDiffuse{})), plain = bake(with(design, LambertianDiffuse{}));
        const Shading<float> ours = in_float(matt->shading), theirs = in_float(plain->shading);
        Random random(7);
        std::vector<glm::vec3> k1, k2, values(count);
        for (std::size_t i = 0; i < count; ++i) {
            k1.emplace_back(test::random_direction(random));
            k2.emplace_back(test::random_direction(random));
        }
        const Pair pair = interleave(
            state, count, [&] { evaluate_pairs(ours, k1, k2, values); },
            [&] { evaluate_pairs(theirs, k1, k2, values); });
        report.add(at_most_times(what, pair, 10));
    });
}

// Processor time of a bake with them but for that of one without.
void add_bake_of(Report& report, const char* name, const Design& design, Quality quality, double wanted) {
    const std::string what = fmt::format("{}: what matt facets add to the {} bake", name,
                                         quality == Quality::draft ? "draft" : "final");
    add_benchmark(what, 5, [=, &report](benchmark::State& state) {
        const Design matt = with(design, FacetDiffuse{}), plain = with(design, LambertianDiffuse{});
        const Pair pair = interleave(
            state, 1, [&] { bake(matt, {.quality = quality}); }, [&] { bake(plain, {.quality = quality}); },
            Time::processor);
        report.add(within(what, pair.ours - pair.theirs, wanted));
    });
}

}  // namespace

void add_facets(Report& report) {
    const std::pair<const char*, Design> designs[] = {{"Gaussian (0.1, 1)", brushed()},
                                                      {"GGX 0.3", test::design_of(GgxLobe{0.3, 0.3})},
                                                      {"painted 512", painted(512)}};
    for (const auto& [name, design] : designs) {
        add_evaluation_of(report, name, design);
        add_bake_of(report, name, design, Quality::draft, 0.1);
        add_bake_of(report, name, design, Quality::final, 1);
    }
}

}  // namespace nacre::bench
