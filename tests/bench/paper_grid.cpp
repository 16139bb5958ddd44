#include "tests/bench/paper_grid.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace nacre::bench {

using std::numbers::pi;

std::vector<dvec3> PaperGrid::directions() const {
    std::vector<dvec3> all;
    for (int j = 0; j < azimuths_; ++j)
        for (int i = 0; i < polar_; ++i) {
            const double theta = 0.5 * pi * i / (polar_ - 1), phi = 0.5 * pi * j / (azimuths_ - 1);
            all.push_back({std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                           std::max(std::cos(theta), 0.0)});
        }
    return all;
}

void PaperGrid::fill(const FacetDistribution& facets) {
    values_.clear();
    for (const dvec3 k : directions()) values_.push_back(facets.area(k).g);
}

double PaperGrid::at(dvec3 k) const {
    const double theta = std::acos(std::min(k.z, 1.0)) / (0.5 * pi) * (polar_ - 1);
    const double phi = std::atan2(std::fabs(k.y), std::fabs(k.x)) / (0.5 * pi) * (azimuths_ - 1);
    const int i = std::min(static_cast<int>(theta), polar_ - 2);
    const int j = std::min(static_cast<int>(phi), azimuths_ - 2);
    const double s = theta - i, t = phi - j;
    const double* row = values_.data() + j * polar_ + i;
    return (row[0] * (1 - s) + row[1] * s) * (1 - t) + (row[polar_] * (1 - s) + row[polar_ + 1] * s) * t;
}

}  // namespace nacre::bench
