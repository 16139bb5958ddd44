// Does any direction reflect more than it gets?
#pragma once

#include <stop_token>

#include "core/bake/tables.h"
#include "core/measure/reference.h"

namespace nacre {

struct AlbedoCheck {
    double worst = 0;    // the largest R at F = 1
    int violations = 0;  // directions with R > 1 + 1e-6
    int directions = 0;
};

// The paper's count of directions, 10 in theta by 20 in phi (Ashikhmin 2000, sec. 5.2 and 6.4). By the bake's
// quadrature, and by the reference where that cannot tell R from 1.
AlbedoCheck measure_albedo(const Tables& tables, const Reference& reference, std::stop_token stop);

}  // namespace nacre
