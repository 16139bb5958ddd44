// What multiple bounces cost: evaluation with and without, and the bake.
#include <fmt/core.h>

#include "core/bake/brdf_pairs.h"
#include "core/model/float_shading.h"
#include "tests/bench/bench_designs.h"
#include "tests/bench/subjects.h"
#include "tests/core/random_directions.h"

namespace nacre::bench {
namespace {

Design with(Design design, const Multibounce& bounces) {
    design.fresnel = SchlickFresnel{{1, 0.71, 0.29}};
    design.multibounce = bounces;
    return design;
}

void add_evaluation_with(Report& report, const char* name, const Design& design) {
    const std::string what = fmt::format("BRDF, batch: {} with fitted bounces against without", name);
    add_benchmark(what, 301, [=, &report](benchmark::State& state) {
        constexpr std::size_t count = 4096;
        const auto bouncing = bake(with(design, MomentumMultibounce{})),
                   plain = bake(with(design, NoMultibounce{}));
        const Shading<float> ours = in_float(bouncing->shading), theirs = in_float(plain->shading);
        Random random(7);
        std::vector<glm::vec3> k1, k2, values(count);
        for (std::size_t i = 0; i < count; ++i) {
            k1.emplace_back(test::random_direction(random));
            k2.emplace_back(test::random_direction(random));
        }
        const Pair pair = interleave(
            state, count, [&] { evaluate_pairs(ours, k1, k2, values); },
            [&] { evaluate_pairs(theirs, k1, k2, values); });
        report.add(at_most_times(what, pair, 1.6));
    });
}

// Processor time of a bake with them but for that of one without.
void add_bake_with(Report& report, const char* name, const Design& design, const Multibounce& bounces,
                   double wanted) {
    const std::string what = fmt::format("{}: what {} bounces add to the bake", name, kind_name(bounces));
    add_benchmark(what, 5, [=, &report](benchmark::State& state) {
        const Design bouncing = with(design, bounces), plain = with(design, NoMultibounce{});
        const Pair pair = interleave(
            state, 1, [&] { bake(bouncing); }, [&] { bake(plain); }, Time::processor);
        report.add(within(what, pair.ours - pair.theirs, wanted));
    });
}

}  // namespace

void add_multibounce(Report& report) {
    const std::pair<const char*, Design> designs[] = {{"Gaussian (0.1, 1)", brushed()},
                                                      {"GGX 0.3", test::design_of(GgxLobe{0.3, 0.3})},
                                                      {"painted 512", painted(512)}};
    for (const auto& [name, design] : designs) {
        add_evaluation_with(report, name, design);
        add_bake_with(report, name, design, RankOneMultibounce{}, 20e-3);
        add_bake_with(report, name, design, MomentumMultibounce{}, 3);
    }
}

}  // namespace nacre::bench
