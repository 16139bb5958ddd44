// Brings the mean normal of p to n by changing how many facets there are of each normal.
#pragma once

#include "core/model/layer.h"

namespace nacre {

// The change is the smallest in relative entropy, the integral of p' ln(p'/p) (Kullback and Leibler 1951): of
// all distributions whose mean normal lies along n the nearest to p is p' = p exp(lambda . h)/Z, lambda along
// the surface (Csiszar 1975, theorem 3.1). It is positive wherever p is and nowhere else, and the only one,
// since ln Z is convex in lambda.
//
// A painted layer becomes that texel by texel. Any other lobe stays a lobe: it takes the share of area and
// the mean normal that this factor gives to the Gaussian of its own mean and covariance, so that it is
// tilted as far as that one shifts, and keeps its widths. The sum of the weights stays; layers that are left
// out stay as they are.
//
// The mean normal of the result has no part along the surface above 1e-9. A UserError of no file where p
// cannot be balanced so: its facets are all tilted to one side, or almost nothing would be left of a layer.
Distribution balanced(const Distribution& distribution);

}  // namespace nacre
