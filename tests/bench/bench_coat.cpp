// What a clear coat costs.
#include <fmt/core.h>

#include "tests/bench/bench_designs.h"
#include "tests/bench/part_costs.h"

namespace nacre::bench {

void add_coat(Report& report) {
    const std::pair<const char*, Design> designs[] = {
        {"Gaussian (0.1, 1)", brushed()},
        {"GGX 0.3", test::design_of(GgxLobe{0.3, 0.3})},
        {"GGX 0.3, leaning", test::design_of(GgxLobe{0.3, 0.3}, 20)},
        {"painted 512", painted(512)}};
    for (const auto& [name, plain] : designs) {
        Design coated = plain;
        coated.coat = ClearCoat{};
        add_evaluation_cost(report, fmt::format("BRDF, batch: {} with a coat against without", name), coated,
                            plain, 4);
        add_bake_cost(report, fmt::format("{}: what a coat adds to the draft bake", name), coated, plain,
                      Quality::draft, 0.1);
        add_bake_cost(report, fmt::format("{}: what a coat adds to the final bake", name), coated, plain,
                      Quality::final, 1);
    }
}

}  // namespace nacre::bench
