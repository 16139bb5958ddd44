// What matt facets cost beside Lambert's law for the whole surface.
#include <fmt/core.h>

#include "tests/bench/bench_designs.h"
#include "tests/bench/part_costs.h"

namespace nacre::bench {

void add_facets(Report& report) {
    const std::pair<const char*, Design> designs[] = {{"Gaussian (0.1, 1)", brushed()},
                                                      {"GGX 0.3", test::design_of(GgxLobe{0.3, 0.3})},
                                                      {"painted 512", painted(512)}};
    for (const auto& [name, design] : designs) {
        Design matt = design, plain = design;
        matt.diffuse = FacetDiffuse{};
        plain.diffuse = LambertianDiffuse{};
        add_evaluation_cost(report, fmt::format("BRDF, batch: {} with matt facets against Lambertian", name),
                            matt, plain, 10);
        add_bake_cost(report, fmt::format("{}: what matt facets add to the draft bake", name), matt, plain,
                      Quality::draft, 0.1);
        add_bake_cost(report, fmt::format("{}: what matt facets add to the final bake", name), matt, plain,
                      Quality::final, 1);
    }
}

}  // namespace nacre::bench
