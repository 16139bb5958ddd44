#include "core/bake/stretched_grid.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace nacre {
namespace {

using std::numbers::pi;

// D is kept above this part of Mz, so that the coordinates exist where no facet leans at all; S absorbs it.
constexpr double smallest_width = 1e-6;

}  // namespace

// 2 v = a/(y + a) + 1/(y + 1): the positive root of 2 v y^2 - (1 - 2 v)(1 + a) y - 2 (1 - v) a = 0.
double cotangent_at_v(double v, double a) {
    const double b = 0.5 * (1 - 2 * v) * (1 + a);
    const double root = std::sqrt(b * b + 4 * v * (1 - v) * a);
    return b >= 0 ? (b + root) / (2 * v) : 2 * (1 - v) * a / (root - b);
}

namespace {

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

}  // namespace

dvec2 azimuth_at_psi(double psi, dvec2 stretch) {
    const dvec2 e = direction_at(psi);
    return glm::normalize(dvec2{e.x * stretch.y, e.y * stretch.x});
}

// Halves the interval of phi, in quarter turns; psi rises with phi within every quarter.
dvec2 azimuth_at_rho(double rho, dvec2 stretch) {
    const double quarter = std::floor(rho);
    if (rho == quarter) return direction_at(rho);
    double low = quarter, high = quarter + 1;
    for (int i = 0; i < 60; ++i) {
        const double phi = 0.5 * (low + high);
        const dvec2 e = stretch * direction_at(phi);
        const double psi = Shading<double>::quarter_turns(e.x, e.y);
        (0.5 * (psi + phi) < rho ? low : high) = phi;
    }
    return direction_at(0.5 * (low + high));
}

StretchedGrid::StretchedGrid(const FacetDistribution& distribution, const BakePlan& plan)
    : distribution_(distribution),
      symmetry_(plan.symmetry.symmetry),
      nodes_psi_(plan.nodes.psi),
      nodes_rho_(plan.nodes.rho),
      moment_(distribution.area({0, 0, 1}).gradient) {
    fit_ellipse(plan.symmetry);
    for (int row = 0; row < nodes_psi_; ++row) {
        const dvec2 e = area_azimuth(row);
        data_.push_back(static_cast<float>(width(std::atan2(e.y, e.x)) / ellipse(e)));
    }
    auto& shape = shading_.surface.tables;
    shape.moment = moment_;
    shape.axis = axis_;
    shape.stretch = stretch_;
    shape.symmetry = static_cast<int>(symmetry_);
    shape.nodes_psi = nodes_psi_;
    shading_.data = data_.data();
}

// D(phi): g - k.M at grazing, its mean over phi and phi + pi. Taking both sides keeps D and with it the
// coordinates smooth for a p that leans to one side, where one of the two all but vanishes.
double StretchedGrid::width(double phi) const {
    const dvec3 k{std::cos(phi), std::sin(phi), 0};
    const double both = distribution_.projected_area(k) + distribution_.projected_area(-k);
    return std::fmax(0.5 * both, smallest_width * moment_.z);
}

// The ellipse through D along the axis where it is least, and across. D is the support function of a flat
// figure, so it has one minimum between neighbours of a dense row.
void StretchedGrid::fit_ellipse(const DistributionSymmetry& symmetry) {
    double axis = symmetry.axis * (pi / 180);
    if (symmetry_ == Symmetry::none) {
        constexpr int steps = 64;
        int best = 0;
        for (int i = 1; i < steps; ++i)
            if (width(pi * i / steps) < width(pi * best / steps)) best = i;
        double low = pi * (best - 1) / steps, high = pi * (best + 1) / steps;
        const double ratio = 1 / std::numbers::phi;
        while (high - low > 1e-10) {
            const double a = high - ratio * (high - low), b = low + ratio * (high - low);
            if (width(a) < width(b)) {
                high = b;
            } else {
                low = a;
            }
        }
        axis = 0.5 * (low + high);
    }
    axis_ = {std::cos(axis), std::sin(axis)};
    stretch_ =
        symmetry_ == Symmetry::isotropic ? dvec2{width(axis)} : dvec2{width(axis), width(axis + pi / 2)};
}

double StretchedGrid::row_turns(double row, int nodes) const {
    switch (symmetry_) {
        case Symmetry::isotropic:
            break;
        case Symmetry::quarter:
            return row / (nodes - 1);
        case Symmetry::half:
            return 2 * row / (nodes - 1);
        case Symmetry::none:
            return 4 * row / nodes;
    }
    return 0;
}

dvec2 StretchedGrid::turned(dvec2 e) const {
    return {axis_.x * e.x - axis_.y * e.y, axis_.y * e.x + axis_.x * e.y};
}

dvec2 StretchedGrid::area_azimuth(double row) const {
    return turned(azimuth_at_psi(row_turns(row, nodes_psi_), stretch_));
}

dvec2 StretchedGrid::albedo_azimuth(double row) const {
    return turned(azimuth_at_rho(row_turns(row, nodes_rho_), stretch_));
}

double StretchedGrid::ellipse(dvec2 e) const {
    return std::hypot(stretch_.x * (axis_.x * e.x + axis_.y * e.y),
                      stretch_.y * (axis_.x * e.y - axis_.y * e.x));
}

double StretchedGrid::grazing_width(dvec2 e) const { return shading_.table_spot({e.x, e.y, 0}).q; }

// w = a/(y + a) with y = cot(theta), a = 2 D/Mz.
dvec3 StretchedGrid::area_direction(double w, double row) const {
    const dvec2 e = area_azimuth(row);
    const dvec2 polar = glm::normalize(dvec2{2 * grazing_width(e) * (1 - w), w * moment_.z});
    return {e * polar.y, polar.x};
}

dvec3 StretchedGrid::albedo_direction(double v, double row) const {
    if (v <= 0) return {0, 0, 1};
    const dvec2 e = albedo_azimuth(row);
    const dvec2 polar = glm::normalize(dvec2{cotangent_at_v(v, 2 * grazing_width(e) / moment_.z), 1});
    return {e * polar.y, polar.x};
}

double StretchedGrid::shape_value(double w, double row, double g) const {
    if (w <= 0) return 0;
    const dvec3 k = area_direction(w, row);
    const double scale = k.z * moment_.z + 2 * shading_.table_spot(k).q;
    return std::clamp((g - glm::dot(k, moment_)) / scale, 0.0, 1.0);
}

}  // namespace nacre
