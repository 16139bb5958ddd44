// Does any direction reflect more than it gets?
#pragma once

#include <stop_token>

#include "core/bake/tables.h"
#include "core/verify/reference.h"

namespace nacre {

struct AlbedoCheck {
    // The largest R at F = 1, of any colour where tints differ; infinite where one is NaN.
    double worst = 0;
    int violations = 0;  // directions with R > 1 + 1e-6
    int directions = 0;
    int unsettled = 0;  // directions whose R could not be distinguished from 1 within the time limit
};

// Rings of directions, the last at 89.5 degrees. The paper's count unless another is asked for (Ashikhmin
// 2000, sec. 5.2 and 6.4).
struct AlbedoRings {
    int polar = 10;
    int azimuths = 20;
};

// By the bake's quadrature, and by the reference where that cannot distinguish R from 1, the largest R first.
AlbedoCheck measure_albedo(const Tables& tables, const Reference& reference, std::stop_token stop,
                           const AlbedoRings& rings = {});

}  // namespace nacre
