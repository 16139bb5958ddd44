#include "core/study/paper_grid.h"

#include <vector>

#include "core/model/polar_angles.h"

namespace nacre {
namespace {

// Degrees from 0 to 90 by halves, and ever closer together below the first of them: g of a narrow p bends
// within less than that of the horizon and of the narrow axis.
std::vector<double> crowded_angles() {
    std::vector<double> angles{0};
    for (double angle = 1e-3; angle < 0.5; angle *= 1.4) angles.push_back(angle);
    for (int i = 1; i <= 180; ++i) angles.push_back(0.5 * i);
    return angles;
}

template <class ErrorOf>
WorstError worst_of(const Tables& tables, const std::stop_token& stop, const ErrorOf& error_of) {
    WorstError worst;
    const std::vector<double> angles = crowded_angles();
    for (const double elevation : angles)
        for (const double phi : angles) {
            if (stop.stop_requested()) throw BakeCancelled();
            const double theta = 90 - elevation;
            const dvec3 k = polar_direction(theta, phi);
            const double error = error_of(k, tables.distribution->area(k).g);
            if (!(error <= worst.error)) worst = {error, theta, phi};
        }
    return worst;
}

}  // namespace

GridTable paper_table(const FacetDistribution& p, PaperPoints points, const std::stop_token& stop) {
    const bool steep = points == PaperPoints::polar_20_quarter;
    const int polar = steep ? paper_azimuths : paper_polar, azimuths = steep ? paper_polar : paper_azimuths;
    const int round = points == PaperPoints::polar_10_hemisphere ? azimuths : 4 * (azimuths - 1);
    GridTable table(PlainGrid(polar, round, {Symmetry::quarter, 0}));
    table.fill_area([&](int, dvec3 k) { return p.area(k).g; }, stop);
    return table;
}

WorstError worst_error(const Tables& tables, const GridTable& table, const std::stop_token& stop) {
    return worst_of(tables, stop, [&](dvec3 k, double exact) {
        return area_error(tables.shading, k, table.area(k), exact);
    });
}

WorstError worst_error(const Tables& tables, const std::stop_token& stop) {
    return worst_of(tables, stop,
                    [&](dvec3 k, double exact) { return area_error(tables.shading, k, exact); });
}

}  // namespace nacre
