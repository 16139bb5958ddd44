#include "core/bake/coupling.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/bake/stretched_grid.h"
#include "core/model/quadrature.h"

namespace nacre {
namespace {

using std::numbers::pi;
using Integrals = Values<4>;  // R with F = 1, then (whole - R)+ of three colours

// Below this part of pi nothing is left for the diffuse term; 1/integral would only blow up rounding.
constexpr double nothing_left = 1e-9;

Integrals integrand(const Shading<double>& shading, dvec3 k) {
    const auto spot = shading.table_spot(k);
    const double g = shading.projected_area(k, spot);
    const auto albedo = shading.albedo_spot(k, spot);
    const dvec3 share = shading.diffuse_share({k, g, shading.albedo_of(k, g, albedo)});
    return {shading.full_albedo(albedo) * shading.clamped_part(k, g), share.x, share.y, share.z};
}

// Over theta at one azimuth, cell by cell of the table, cos sin dtheta.
Integrals integrate_meridian(const Shading<double>& shading, double phi) {
    const auto& shape = shading.surface.tables;
    const double c = std::cos(phi), s = std::sin(phi);
    const double width = shading.table_spot({c, s, 0}).q;
    Integrals sum{};
    double begin = 0;
    for (int i = 1; i < shape.nodes_v; ++i) {
        const double v = static_cast<double>(i) / (shape.nodes_v - 1);
        const double end =
            i + 1 == shape.nodes_v ? pi / 2 : std::atan2(1.0, cotangent_at_v(v, 2 * width / shape.g_normal));
        for (const QuadraturePoint& node : gauss_legendre<7>()) {
            const double theta = begin + (end - begin) * node.x;
            const double sine = std::sin(theta), cosine = std::cos(theta);
            const Integrals values = integrand(shading, {sine * c, sine * s, cosine});
            const double weight = (end - begin) * node.weight * sine * cosine;
            for (std::size_t j = 0; j < sum.size(); ++j) sum[j] += weight * values[j];
        }
        begin = end;
    }
    return sum;
}

// phi at which rho = (psi + phi)/2 stands on a row of the albedo's tables, first to last: between two of them
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

AlbedoIntegrals integrate_albedo(const Shading<double>& shading) {
    Integrals sum{};
    double covered = 0;
    if (shading.surface.tables.symmetry == Shading<double>::SYMMETRY_ISOTROPIC) {
        sum = integrate_meridian(shading, 0);
        covered = 1;
    } else {
        const std::vector<double> azimuths = row_azimuths(shading);
        covered = azimuths.back() - azimuths.front();
        for (std::size_t i = 0; i + 1 < azimuths.size(); ++i) {
            const Integrals part =
                integrate_adaptively<4>([&](double phi) { return integrate_meridian(shading, phi); },
                                        azimuths[i], azimuths[i + 1], 1e-7, 12);
            for (std::size_t j = 0; j < sum.size(); ++j) sum[j] += part[j];
        }
    }
    for (double& value : sum) value *= 2 * pi / covered;
    AlbedoIntegrals result;
    result.mean = sum[0] / pi;
    for (int i = 0; i < 3; ++i) {
        const double rest = sum[static_cast<std::size_t>(i + 1)];
        result.coupling[i] = rest > nothing_left * pi ? 1 / rest : 0;
    }
    return result;
}

}  // namespace nacre
