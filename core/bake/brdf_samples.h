// Samples of the BRDF for many directions at once.
#pragma once

#include <span>

#include "core/bake/brdf.h"

namespace nacre {

// samples[i] as Brdf::sample(k1[i]) draws them, with other random numbers; where it gives nothing, weight and
// pdf are 0 and k2 is n. Many facets are drawn side by side, values and densities found in vectors as wide as
// the processor has: they agree with evaluate() and pdf() to rounding. Both hold equally many.
void sample_directions(const Brdf& brdf, std::span<const dvec3> k1, Random& random,
                       std::span<BrdfSample> samples);

}  // namespace nacre
