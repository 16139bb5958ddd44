// How many directions reflect more than they get, on the 200 of a paper that does not say where they lie.
#pragma once

#include <stop_token>

#include "core/bake/tables.h"

namespace nacre {

struct ExcessEnergy {
    int directions = 0;  // with R > 1, F = 1
    double largest = 0;  // R
};

// At the middles of cells even in theta and in phi, by the bake's rule to 1e-4.
ExcessEnergy excess_energy(const Tables& tables, int polar, int azimuths, const std::stop_token& stop);

}  // namespace nacre
