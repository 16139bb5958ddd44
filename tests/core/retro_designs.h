// Designs that are retro-reflective.
#pragma once

#include "tests/core/designs.h"
#include "tests/core/random_directions.h"

namespace nacre::test {

inline constexpr dvec3 white{1};

// Two layers that half a turn about n changes, with a diffuse term that takes what they leave.
inline Design lopsided(double retro) {
    Design design = with_layer(design_of(GaussianLobe{0.4, 0.3}, 30, 20), GgxLobe{0.2, 0.3}, 0.6, 25, 150);
    design.fresnel = SchlickFresnel{{0.9, 0.6, 0.3}};
    design.diffuse = CoupledDiffuse{white};
    design.retro.weight = retro;
    return design;
}

inline Design upright(double retro) {
    Design design = design_of(GgxLobe{0.2, 0.2});
    design.retro.weight = retro;
    return design;
}

inline dvec3 turned(dvec3 k) { return {-k.x, -k.y, k.z}; }

inline const dvec3 probes[] = {{0, 0, 1}, polar(0.8, 0.4), polar(0.5, 3.0), polar(0.2, 1.3), polar(0.3, 2.8)};

}  // namespace nacre::test
