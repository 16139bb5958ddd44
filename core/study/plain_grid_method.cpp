#include "core/study/grid_table.h"

namespace nacre {
namespace {

constexpr double rule_tolerance = 1e-4;

StoredTable make_table(const Design& design, const PlainGrid& grid, Wanted wanted,
                       const std::stop_token& stop) {
    const auto table = std::make_shared<GridTable>(grid);
    if (wanted == Wanted::area) {
        const FacetDistribution distribution(design.distribution);
        table->fill_area([&](int, dvec3 k) { return distribution.projected_area(k); }, stop);
        return GridTable::stored(table);
    }
    const auto baked = bake(design, {.threads = 1}, stop);
    const FacetDistribution& distribution = *baked->distribution;
    const AlbedoQuadrature rule(distribution, baked->shading, 1, rule_tolerance);
    table->fill_area([&](int, dvec3 k) { return distribution.projected_area(k); }, stop);
    table->fill_albedo([&](int, dvec3 k, double g) { return rule(k, g); }, stop);
    return GridTable::stored(table);
}

}  // namespace

Method plain_grid_method(const Design& design) {
    Method method{
        .kind = MethodKind::plain_grid,
        .name = "plain grid, exact nodes",
        .about =
            "grids even in theta and phi, bilinear, with exact g in the nodes and R by the bake's own rule "
            "(which reads g from the final tables): what is left is interpolation"};
    const DistributionSymmetry symmetry = find_symmetry(design.distribution);
    for (int cells = 1; cells <= 64; cells *= 2) {
        const PlainGrid grid((paper_polar - 1) * cells + 1, paper_azimuths * cells, symmetry);
        method.settings.push_back({grid.label(), [&design, grid](Wanted wanted, const std::stop_token& stop) {
                                       return make_table(design, grid, wanted, stop);
                                   }});
    }
    return method;
}

}  // namespace nacre
