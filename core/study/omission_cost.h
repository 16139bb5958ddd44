// What each thing that a bake leaves out would cost if it were there.
#pragma once

#include <stop_token>
#include <vector>

#include "core/bake/needs.h"
#include "core/design/design.h"

namespace nacre {

struct BakeCost {
    double seconds = 0;     // one thread, the shortest of several runs
    std::size_t bytes = 0;  // of the tables
};

struct OmissionCost {
    Omission omission;
    BakeCost with_it;  // of the whole bake with that one thing put back in
};

struct OmissionCosts {
    BakeCost bake;  // as the design asks for it
    std::vector<OmissionCost> omissions;
    BakeCost with_all;  // all of them put back in together
};

// Of a final bake. Throws what bake() throws.
OmissionCosts measure_omissions(const Design& design, const std::stop_token& stop);

}  // namespace nacre
