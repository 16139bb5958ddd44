// Pairs of directions that a fit is made for and measured on.
#pragma once

#include <cstdint>
#include <vector>

#include "core/bake/tables.h"

namespace nacre {

struct FitPair {
    dvec3 v, l, h;
    double rho;         // of the design's specular term, mirrored part, F = 1, 1/sr
    double share;       // solid angles times cosines that this pair stands for; sums of it are integrals
    double visibility;  // P(v)/(n.v)
};

// Views as a matt surface sees them, facets as a view sees them and, two in five, spread evenly. Grazing
// directions below 0.01 are left out.
std::vector<FitPair> draw_fit_pairs(const Tables& tables, int count, std::uint64_t seed);

// Facets of density (h.n) p(h) above the horizon.
std::vector<dvec3> draw_fit_facets(const Tables& tables, int count, std::uint64_t seed);

}  // namespace nacre
