// Directions that integrals over both ends of a bounce are summed over.
#pragma once

#include <vector>

#include "core/bake/bounce_walks.h"

namespace nacre {

// So many, evenly in c dk.
std::vector<dvec3> even_directions(int count);

// So many, and some close beside the horizon, where what comes back falls steeply.
std::vector<dvec3> watched_directions(int count);

// So many pairs, evenly in c1 dk1 c2 dk2.
std::vector<BouncePair> even_pairs(std::size_t count);

}  // namespace nacre
