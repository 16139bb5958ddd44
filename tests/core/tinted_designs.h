// Designs whose layers have tints.
#pragma once

#include "tests/core/designs.h"

namespace nacre::test {

inline constexpr glm::dvec3 crimson{0.7, 0.02, 0.08}, midnight{0.03, 0.04, 0.3};

// Two layers slanted by 40 degrees to opposite sides.
inline Design velvet_of(glm::dvec3 one, glm::dvec3 other) {
    const GaussianLobe threads{0.5, limits::infinity};
    Design design = with_layer(design_of(threads, 40), threads, 1, 40, 180);
    design.distribution.layers[0].tint = one;
    design.distribution.layers[1].tint = other;
    return design;
}

inline Design velvet() { return velvet_of(crimson, midnight); }

}  // namespace nacre::test
