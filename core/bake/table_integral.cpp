#include "core/bake/table_integral.h"

#include <cmath>

#include "core/bake/stretched_grid.h"

namespace nacre {

using std::numbers::pi;

// Over theta at one azimuth, cell by cell of the table, cos sin dtheta. In v the interpolant is a straight
// line on each cell; with y = cot(theta), 2 v = a/(y + a) + 1/(y + 1) and cos sin dtheta = -y/(1 + y^2)^2 dy.
WeightedDirections meridian(const Shading<double>& shading, double phi) {
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
    return directions;
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

}  // namespace nacre
