#include "tests/bench/part_costs.h"

#include "core/bake/brdf_pairs.h"
#include "core/model/float_shading.h"
#include "tests/core/random_directions.h"

namespace nacre::bench {

void add_evaluation_cost(Report& report, const std::string& what, const Design& with, const Design& without,
                         double times) {
    add_benchmark(what, 301, [=, &report](benchmark::State& state) {
        constexpr std::size_t count = 4096;
        const auto tables = bake(with), plain = bake(without);
        const Shading<float> ours = in_float(tables->shading), theirs = in_float(plain->shading);
        Random random(7);
        std::vector<glm::vec3> k1, k2, values(count);
        for (std::size_t i = 0; i < count; ++i) {
            k1.emplace_back(test::random_direction(random));
            k2.emplace_back(test::random_direction(random));
        }
        const Pair pair = interleave(
            state, count, [&] { evaluate_pairs(ours, k1, k2, values); },
            [&] { evaluate_pairs(theirs, k1, k2, values); });
        report.add(at_most_times(what, pair, times));
    });
}

void add_bake_cost(Report& report, const std::string& what, const Design& with, const Design& without,
                   Quality quality, double wanted) {
    add_benchmark(what, 5, [=, &report](benchmark::State& state) {
        const Pair pair = interleave(
            state, 1, [&] { bake(with, {.quality = quality}); }, [&] { bake(without, {.quality = quality}); },
            Time::processor);
        report.add(within(what, pair.ours - pair.theirs, wanted));
    });
}

}  // namespace nacre::bench
