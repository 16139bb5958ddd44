// What multiple bounces cost.
#include <fmt/core.h>

#include "tests/bench/bench_designs.h"
#include "tests/bench/part_costs.h"

namespace nacre::bench {

void add_multibounce(Report& report) {
    const std::pair<const char*, Design> designs[] = {{"Gaussian (0.1, 1)", brushed()},
                                                      {"GGX 0.3", test::design_of(GgxLobe{0.3, 0.3})},
                                                      {"painted 512", painted(512)}};
    for (const auto& [name, design] : designs) {
        Design plain = design;
        plain.fresnel = SchlickFresnel{{1, 0.71, 0.29}};
        Design even = plain, fitted = plain;
        even.multibounce = RankOneMultibounce{};
        fitted.multibounce = MomentumMultibounce{};
        add_evaluation_cost(report, fmt::format("BRDF, batch: {} with fitted bounces against without", name),
                            fitted, plain, 1.6);
        add_bake_cost(report, fmt::format("{}: what rank_one bounces add to the bake", name), even, plain,
                      Quality::final, 20e-3);
        add_bake_cost(report, fmt::format("{}: what momentum bounces add to the bake", name), fitted, plain,
                      Quality::final, 3);
    }
}

}  // namespace nacre::bench
