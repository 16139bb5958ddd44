#include "core/bake/coupling.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/bake/direction_sums.h"
#include "core/bake/stretched_grid.h"

namespace nacre {
namespace {

using std::numbers::pi;
using Integrals = Values<6>;  // R with F = 1 of three colours, then (whole - R)+ of each

// Below this part of pi nothing is left for the diffuse term; 1/integral would only blow up rounding.
constexpr double nothing_left = 1e-9;

// Over theta at one azimuth, cell by cell of the table, cos sin dtheta. In v the interpolant is a straight
// line on each cell; with y = cot(theta), 2 v = a/(y + a) + 1/(y + 1) and cos sin dtheta = -y/(1 + y^2)^2 dy.
Integrals integrate_meridian(const Shading<double>& shading, double phi) {
    const auto& shape = shading.surface.tables;
    const double c = std::cos(phi), s = std::sin(phi);
    const double a = 2 * shading.table_spot({c, s, 0}).q / shape.g_normal;
    const int cells = shape.nodes_v - 1;
    WeightedDirections directions;
    for (int i = 0; i < cells; ++i)
        for (const QuadraturePoint& node : gauss_legendre<7>()) {
            const double y = cotangent_at_v((i + node.x) / cells, a);
            const double sine = 1 / std::sqrt(1 + y * y), cosine = y * sine;
            const double dv_dy = 0.5 * (a / ((y + a) * (y + a)) + 1 / ((y + 1) * (y + 1)));
            directions.add({sine * c, sine * s, cosine},
                           node.weight / cells * cosine * sine * sine * sine / dv_dy);
        }
    return sum_shares(shading, directions);
}

// phi at which rho = (psi + phi)/2 is on a row of the albedo's tables, first to last: between two of them
// the interpolant is smooth but for the rows of g, which adaptive halving finds.
std::vector<double> row_azimuths(const Shading<double>& shading) {
    const auto& shape = shading.surface.tables;
    const auto symmetry = static_cast<Symmetry>(shape.symmetry);
    const int cells = azimuth_cells(shape.nodes_rho, symmetry);
    const double axis = std::atan2(shape.axis.y, shape.axis.x);
    std::vector<double> azimuths;
    for (int i = 0; i <= cells; ++i) {
        const dvec2 e = azimuth_at_rho(row_turns(i, shape.nodes_rho, symmetry), shading);
        const double phi = std::atan2(e.y, e.x);
        azimuths.push_back(axis + (i > 0 && phi < 1e-12 ? phi + 2 * pi : phi));
    }
    return azimuths;
}

}  // namespace

AlbedoIntegrals integrate_albedo(const Shading<double>& shading, double tolerance, Workers& workers) {
    Integrals sum{};
    double covered = 0;
    if (shading.surface.tables.symmetry == Shading<double>::SYMMETRY_ISOTROPIC) {
        sum = integrate_meridian(shading, 0);
        covered = 1;
    } else {
        const std::vector<double> azimuths = row_azimuths(shading);
        covered = azimuths.back() - azimuths.front();
        std::vector<Integrals> parts(azimuths.size() - 1);
        workers.for_each(static_cast<int>(parts.size()), [&](int i) {
            const std::size_t at = static_cast<std::size_t>(i);
            parts[at] = integrate_adaptively<6>([&](double phi) { return integrate_meridian(shading, phi); },
                                                azimuths[at], azimuths[at + 1], tolerance, 12);
        });
        for (const Integrals& part : parts)
            for (std::size_t j = 0; j < sum.size(); ++j) sum[j] += part[j];
    }
    for (double& value : sum) value *= 2 * pi / covered;
    AlbedoIntegrals result;
    for (int i = 0; i < 3; ++i) {
        const auto at = static_cast<std::size_t>(i);
        result.mean[i] = sum[at] / pi;
        const double rest = sum[3 + at];
        result.coupling[i] = rest > nothing_left * pi ? 1 / rest : 0;
    }
    return result;
}

}  // namespace nacre
