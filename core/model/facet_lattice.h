// A lattice of facets for sums over p.
#pragma once

#include <cstddef>
#include <vector>

#include "core/model/facet_distribution.h"

namespace nacre {

// Facets spread evenly over each lobe's own width, about `count` a lobe, with their shares of area: a lattice
// for sums over p. Lobes without a smooth form give their own facets.
std::vector<Facet> facet_lattice(const FacetDistribution& p, std::size_t count);

}  // namespace nacre
