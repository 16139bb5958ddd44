// The facets of all painted and modulated layers as one set. Sixteen of 1024 x 1024 would be walked one by
// one for every direction of a table; merged they are walked once.
#pragma once

#include <cstddef>
#include <memory>

#include "core/model/facet_distribution.h"

namespace nacre {

// Facets that stand for the painted and modulated layers of a design.
std::size_t count_facets(const Distribution& design);

// From so many facets on the cost of walking them is felt.
inline constexpr std::size_t many_facets = std::size_t{1} << 21;

// The same p, its smooth lobes as they are and all facets in one lobe: about a million cells of the sphere,
// small where there are many facets, each of which stands for what falls into it and spreads as far, the mean
// of sixteen neighbours. g is off by some millionths at the most; merging_error() tells. `distribution` is
// that of `design`.
std::shared_ptr<const FacetDistribution> merge_facets(const Distribution& design,
                                                      const FacetDistribution& distribution);

// The largest |g - g merged| on some directions down to grazing, relative to the larger of g and N c.
double merging_error(const FacetDistribution& distribution, const FacetDistribution& merged);

}  // namespace nacre
