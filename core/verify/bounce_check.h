// Do multiple bounces give back what the first left, no more and no less?
#pragma once

#include <stop_token>

#include "core/bake/tables.h"

namespace nacre {

struct BounceCheck {
    double furnace = 0;  // worst |1 - E - (the integral of M + e e'/(pi <e>) over c' dk')|, F = 1
    int directions = 0;
};

// Of tables with bounces, by a quadrature that has nothing in common with what they were made by. Throws
// BakeCancelled.
BounceCheck measure_bounces(const Tables& tables, std::stop_token stop);

}  // namespace nacre
