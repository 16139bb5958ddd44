// The canvas in the material's own colours.
#pragma once

#include "core/bake/tables.h"
#include "core/paint/density_picture.h"

namespace nacre {

// A sphere that is lit and seen from the same side, so that every facet normal shines where the canvas has
// it: rho(h, h) (h.n) `light` through the display transform. `light` is the irradiance on what faces it,
// times the exposure.
HemispherePicture lit_picture(const Tables& tables, glm::dvec3 light, const HemisphereView& view,
                              int divisor);

}  // namespace nacre
