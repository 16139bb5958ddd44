// Conditions on a design as a whole, beyond the range of each value.
#pragma once

#include <string>

#include "core/design/design.h"

namespace nacre {

// Throws a UserError when no facet is left, when N = <n.h> must be 0, when kd + ks exceeds 1, or when
// bounces are asked for that the design cannot have.
// Other distributions with N = 0 show only in the bake.
void check_design(const Design& design, const std::string& file);

// Why a design can have no multiple bounces; empty where it can.
std::string bounce_problem(const Design& design);

// What is to be said of an intensity above 1 wherever a design's validity is shown; empty for any other.
std::string energy_note(double intensity);

}  // namespace nacre
