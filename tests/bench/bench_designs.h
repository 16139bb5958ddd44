// The designs that several benchmarks share.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/bake/bake.h"
#include "tests/core/designs.h"

namespace nacre::bench {

// The paper's brushed metal (fig. 5).
inline Design brushed() { return test::design_of(GaussianLobe{0.1, 1.0}); }

inline Design brushed_coupled() {
    Design design = brushed();
    design.diffuse = CoupledDiffuse{};
    return design;
}

// Soft strokes and a hard edge, with no symmetry.
inline Design painted(int side) {
    const auto value = [](double x, double y) {
        const double stroke = std::exp(-40 * std::pow(y - 0.3 * std::sin(4 * x), 2)) * std::exp(-2 * x * x);
        const double blob = std::exp(-60 * (std::pow(x - 0.35, 2) + std::pow(y + 0.4, 2)));
        return stroke + 0.7 * blob + (x > -0.7 && x < -0.4 && std::fabs(y) < 0.3 ? 0.5 : 0);
    };
    return test::design_of(PaintedLobe{test::picture_of(side, value)});
}

}  // namespace nacre::bench
