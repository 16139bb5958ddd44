// Beckmann facets, normalised to N = <n.h> = 1. Eq. 34 is a mixture of them, so they are a function of their
// own.
#pragma once

#include "core/model/lobe.h"

namespace nacre {

// g and its gradient for every k of the sphere, widths along x and y (Walter et al. 2007;
// docs/mathematics.md, sec. 7).
Area beckmann_area(dvec3 k, dvec2 alpha);

// A facet as k sees it.
dvec3 beckmann_sample_visible(dvec3 k, dvec2 alpha, Random& random);

}  // namespace nacre
