// The facets of all painted and modulated layers as one set. Sixteen of 1024 x 1024 would be walked one by
// one for every direction of a table; merged they are walked once.
#pragma once

#include <cstddef>
#include <memory>

#include "core/model/facet_distribution.h"

namespace nacre {

// Facets that represent the painted and modulated layers of a design.
std::size_t count_facets(const Distribution& design);

// Above this number of facets, walking them dominates the bake.
inline constexpr std::size_t many_facets = std::size_t{1} << 21;

// The same p with its smooth lobes unchanged and all facets in one lobe: about a million cells of the sphere,
// small where there are many facets, each of which represents the facets within it and has their spread,
// the mean of sixteen neighbours. The error of g is a few millionths at most; see merging_error().
// `distribution` is that of `design`.
std::shared_ptr<const FacetDistribution> merge_facets(const Distribution& design,
                                                      const FacetDistribution& distribution);

// The largest |g - g merged| on some directions down to grazing, relative to the larger of g and N c.
double merging_error(const FacetDistribution& distribution, const FacetDistribution& merged);

}  // namespace nacre
