// A first mixture from p alone, by expectation and maximisation.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/bake/workers.h"
#include "core/fit/lobe_terms.h"
#include "core/model/lobe.h"

namespace nacre {

// Lobes for facets that are drawn with density (h.n) p(h). Slopes about a lobe's own normal are normally
// distributed for Beckmann, and for GGX Student's t with two degrees of freedom, so that each step is in
// closed form. Untilted lobes all stand on n. Weights sum to 1.
std::vector<LobeFrame> em_lobes(std::span<const dvec3> facets, LobeShape shape, int count, bool tilted,
                                std::uint64_t seed, Workers& workers);

}  // namespace nacre
