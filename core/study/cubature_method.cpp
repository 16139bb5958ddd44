#include <fmt/core.h>

#include "core/study/grid_table.h"
#include "core/verify/adaptive_albedo.h"
#include "core/verify/bare_surface.h"
#include "core/verify/facet_integral.h"

namespace nacre {
namespace {

StoredTable make_table(const Design& design, double tolerance, Wanted wanted, const std::stop_token& stop) {
    const BareSurface surface(design);
    const auto table = std::make_shared<GridTable>(
        PlainGrid(paper_polar, paper_azimuths, find_symmetry(design.distribution)));
    const AdaptiveArea area(surface.distribution, tolerance);
    table->fill_area([&](int, dvec3 k) { return area(k, stop); }, stop);
    if (wanted == Wanted::area_and_albedo) {
        const AdaptiveAlbedo albedo(surface.distribution, tolerance);
        table->fill_albedo(
            [&](int, dvec3 k, double g) {
                return albedo(
                    {surface.shading, k, g, 1}, [&](dvec3 k2) { return table->area(k2); }, stop);
            },
            stop);
    }
    return GridTable::stored(table);
}

}  // namespace

Method cubature_method(const Design& design) {
    Method method{
        .kind = MethodKind::cubature,
        .name = "200-point grid, adaptive cubature",
        .about =
            "the paper's 10 x 20 grid in theta and phi, bilinear; every node by adaptive Gauss-Kronrod "
            "integration in the lobes' own coordinates to an absolute tolerance; the texels of a picture "
            "are summed"};
    for (const double tolerance : {1e-1, 1e-2, 1e-3, 1e-4, 1e-5})
        method.settings.push_back({fmt::format("tolerance {:.0e}", tolerance),
                                   [&design, tolerance](Wanted wanted, const std::stop_token& stop) {
                                       return make_table(design, tolerance, wanted, stop);
                                   }});
    return method;
}

}  // namespace nacre
