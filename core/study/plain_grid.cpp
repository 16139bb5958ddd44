#include "core/study/plain_grid.h"

#include <fmt/core.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace nacre {
namespace {

using std::numbers::pi;

int kept_rows(int azimuths, Symmetry symmetry) {
    switch (symmetry) {
        case Symmetry::isotropic:
            return 1;
        case Symmetry::quarter:
            return azimuths / 4 + 1;
        case Symmetry::half:
            return azimuths / 2 + 1;
        case Symmetry::none:
            break;
    }
    return azimuths;
}

}  // namespace

PlainGrid::PlainGrid(int polar, int azimuths, DistributionSymmetry symmetry)
    : polar_(polar),
      azimuths_(azimuths),
      rows_(kept_rows(azimuths, symmetry.symmetry)),
      symmetry_(symmetry.symmetry),
      axis_(symmetry.axis * (pi / 180)) {
    assert(polar >= 2 && azimuths >= 4 && azimuths % 4 == 0);
}

dvec3 PlainGrid::direction(int node) const {
    const double theta = 0.5 * pi * (node % polar_) / (polar_ - 1);
    const double phi = axis_ + 2 * pi * (node / polar_) / azimuths_;
    const bool horizon = node % polar_ + 1 == polar_;
    const double sine = std::sin(theta);
    return {sine * std::cos(phi), sine * std::sin(phi), horizon ? 0 : std::cos(theta)};
}

double PlainGrid::folded(double azimuth) const {
    switch (symmetry_) {
        case Symmetry::isotropic:
            return 0;
        case Symmetry::quarter:
            return std::fabs(std::remainder(azimuth, pi));
        case Symmetry::half:
            return std::fabs(std::remainder(azimuth, 2 * pi));
        case Symmetry::none:
            break;
    }
    return azimuth - 2 * pi * std::floor(azimuth / (2 * pi));
}

double PlainGrid::value(const std::vector<float>& nodes, dvec3 k) const {
    const double theta = std::atan2(std::hypot(k.x, k.y), k.z);
    const double place = theta / (0.5 * pi) * (polar_ - 1);
    const int column = std::min(static_cast<int>(place), polar_ - 2);
    const double turn = folded(std::atan2(k.y, k.x) - axis_) / (2 * pi) * azimuths_;
    const int first = std::min(static_cast<int>(turn), rows_ - 1);
    const int second = symmetry_ == Symmetry::none ? (first + 1) % rows_ : std::min(first + 1, rows_ - 1);
    auto along = [&](int row) {
        const auto at = static_cast<std::size_t>(row * polar_ + column);
        return std::lerp(static_cast<double>(nodes[at]), static_cast<double>(nodes[at + 1]), place - column);
    };
    return std::lerp(along(first), along(second), turn - first);
}

std::string PlainGrid::label() const { return fmt::format("{} of {} x {} nodes", size(), polar_, azimuths_); }

}  // namespace nacre
