#include "core/bake/stretched_grid.h"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <numbers>

namespace nacre {
namespace {

using std::numbers::pi;

// D is kept above this part of g(n), so that the coordinates exist where no facet is tilted at all; A absorbs
// it.
constexpr double smallest_width = 1e-6;

// The largest concentration of rows where all of p turns away on one side; more starves the other side
// (slanted velvet: least error at 0.8 to 0.85).
constexpr double lean_max = 0.8;

// The sine of the first column's theta, where each row of R holds its own limit at n.
constexpr double least_sine = 1e-9;

// The inverse of quarter_turns(): t of the cubic t (6 - t^2)/5 = u is 2 r sin(a), r^2 = 2, sin(3 a) = 5/2
// u/r^3.
dvec2 direction_at(double turns) {
    const double quarter = std::floor(turns);
    const double u = 2 * (turns - quarter) - 1;
    const double r = std::numbers::sqrt2;
    const double t = 2 * r * std::sin(std::asin(std::clamp(2.5 * u / (r * r * r), -1.0, 1.0)) / 3);
    const dvec2 e = glm::normalize(dvec2{1 - t, 1 + t});
    switch (static_cast<int>(quarter) % 4) {
        case 0:
            return e;
        case 1:
            return {-e.y, e.x};
        case 2:
            return {-e.x, -e.y};
        default:
            return {e.y, -e.x};
    }
}

// The inverse of table_turns().
dvec2 azimuth_at_psi(double psi, const Shading<double>::TableShape& shape) {
    const dvec2 e = direction_at(psi);
    const dvec2 leaned = glm::normalize(dvec2{e.x * shape.stretch.y, e.y * shape.stretch.x});
    return glm::normalize(
        dvec2{leaned.x - shape.lean, leaned.y * std::sqrt((1 - shape.lean) * (1 + shape.lean))});
}

// D(phi): g at grazing, its mean over phi and phi + pi. Taking both sides keeps D and with it the coordinates
// smooth for a p that is tilted to one side, where one of the two all but vanishes.
double grazing_width(const FacetDistribution& distribution, double phi, double least) {
    const dvec3 k{std::cos(phi), std::sin(phi), 0};
    return std::fmax(0.5 * (distribution.projected_area(k) + distribution.projected_area(-k)), least);
}

// The azimuth where D is least. D is the support function of a flat figure, so it has one minimum between
// neighbours of a dense row.
template <class Width>
double narrowest(const Width& width) {
    constexpr int steps = 32;
    int best = 0;
    double least = width(0);
    for (int i = 1; i < steps; ++i) {
        const double value = width(pi * i / steps);
        if (value < least) {
            least = value;
            best = i;
        }
    }
    double low = pi * (best - 1) / steps, high = pi * (best + 1) / steps;
    const double ratio = 1 / std::numbers::phi;
    while (high - low > 1e-4) {
        const double a = high - ratio * (high - low), b = low + ratio * (high - low);
        const bool left = width(a) < width(b);
        (left ? high : low) = left ? b : a;
    }
    return 0.5 * (low + high);
}

}  // namespace

// 2 v = a/(y + a) + 1/(y + 1): the positive root of 2 v y^2 - (1 - 2 v)(1 + a) y - 2 (1 - v) a = 0.
double cotangent_at_v(double v, double a) {
    const double b = 0.5 * (1 - 2 * v) * (1 + a);
    const double root = std::sqrt(b * b + 4 * v * (1 - v) * a);
    return b >= 0 ? (b + root) / (2 * v) : 2 * (1 - v) * a / (root - b);
}

// psi rises with phi and both are the same at every half turn.
dvec2 azimuth_at_rho(double rho, const Shading<double>& shading) {
    double low = rho < 2 ? 0 : 2, high = low + 2;
    if (rho <= low) return direction_at(low);
    if (rho >= high) return direction_at(high);
    std::uintmax_t steps = 60;
    const auto [below, above] = boost::math::tools::toms748_solve(
        [&](double phi) {
            const dvec2 e = direction_at(phi);
            return 0.5 * (shading.table_turns(e.x, e.y) + phi) - rho;
        },
        low, high, low - rho, high - rho, boost::math::tools::eps_tolerance<double>(50), steps);
    return direction_at(0.5 * (below + above));
}

double row_turns(double row, int nodes, Symmetry symmetry) {
    const int cells = azimuth_cells(nodes, symmetry);
    switch (symmetry) {
        case Symmetry::isotropic:
            break;
        case Symmetry::quarter:
            return row / cells;
        case Symmetry::half:
            return 2 * row / cells;
        case Symmetry::none:
            return 4 * row / cells;
    }
    return 0;
}

dvec3 beside_normal(dvec3 k, dvec2 axis) {
    return std::hypot(k.x, k.y) < least_sine ? dvec3{axis * least_sine, 1} : k;
}

StretchedGrid::StretchedGrid(const FacetDistribution& distribution, const DistributionSymmetry& symmetry,
                             int nodes_psi, bool without_moment)
    : symmetry_(symmetry.symmetry) {
    auto& shape = shading_.surface.tables;
    shape.symmetry = static_cast<int>(symmetry_);
    shape.nodes_psi = nodes_psi;
    const Area above = distribution.area({0, 0, 1});
    shape.g_normal = above.g;
    if (without_moment) shape.moment = dvec2(above.gradient);
    fit_ellipse(distribution, symmetry.axis * (pi / 180));
}

// The ellipse through D along the axis and across: the mirror's axis, or where D is least.
void StretchedGrid::fit_ellipse(const FacetDistribution& distribution, double axis) {
    auto& shape = shading_.surface.tables;
    auto width = [&](double phi) {
        return grazing_width(distribution, phi, smallest_width * shape.g_normal);
    };
    if (symmetry_ == Symmetry::none) axis = narrowest(width);
    shape.axis = {std::cos(axis), std::sin(axis)};
    shape.stretch =
        symmetry_ == Symmetry::isotropic ? dvec2{width(axis)} : dvec2{width(axis), width(axis + pi / 2)};
    const bool leans = symmetry_ == Symmetry::half || symmetry_ == Symmetry::none;
    if (!leans || shape.moment != dvec2{0}) return;
    const dvec3 ahead{shape.axis, 0};
    const double here = distribution.projected_area(ahead), there = distribution.projected_area(-ahead);
    if (here + there > 0) shape.lean = lean_max * (here - there) / (here + there);
}

Shading<double>::TableSpot StretchedGrid::spot(dvec3 k) const { return shading_.table_spot(k); }

dvec2 StretchedGrid::turned(dvec2 e) const {
    const dvec2 axis = shape().axis;
    return {axis.x * e.x - axis.y * e.y, axis.y * e.x + axis.x * e.y};
}

dvec2 StretchedGrid::area_azimuth(double row) const {
    return turned(azimuth_at_psi(row_turns(row, shape().nodes_psi, symmetry_), shape()));
}

double StretchedGrid::cotangent_scale(dvec2 e) const { return 2 * spot({e.x, e.y, 0}).q / shape().g_normal; }

// w = a/(y + a) with y = cot(theta), a = 2 |L e|/g(n).
dvec3 StretchedGrid::area_direction(double w, double row) const {
    const dvec2 e = area_azimuth(row);
    const dvec2 polar = glm::normalize(dvec2{cotangent_scale(e) * (1 - w), w});
    return {e * polar.y, polar.x};
}

dvec3 StretchedGrid::albedo_direction(double v, double row, int nodes_rho) const {
    const dvec2 e = turned(azimuth_at_rho(row_turns(row, nodes_rho, symmetry_), shading_));
    const dvec2 polar =
        v > 0 ? glm::normalize(dvec2{cotangent_at_v(v, cotangent_scale(e)), 1}) : dvec2{1, least_sine};
    return {e * polar.y, polar.x};
}

}  // namespace nacre
