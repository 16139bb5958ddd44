// Designs with multiple bounces, at the edge of what can be asked for.
#pragma once

#include <vector>

#include "core/study/extremes.h"

namespace nacre {

// Each model where light goes far between facets, where it comes back sharply, where hardly any stays, where
// hardly any leaves, and where each colour goes its own way; what is fitted, which takes seconds, where it is
// hardest. Then matt facets of the same designs.
void add_bounce_extremes(std::vector<ExtremeCase>& cases);

}  // namespace nacre
