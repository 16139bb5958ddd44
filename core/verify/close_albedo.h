// R as Reference::albedo() gives it, at a cost that any design can pay.
#pragma once

#include "core/verify/reference.h"

namespace nacre {

// Smooth lobes to the tolerance; many facets are merged (merged_facets.h) and summed over some ten thousand
// cells, with an error of about 1e-5.
class CloseAlbedo {
  public:
    // `reference` is kept as a reference.
    CloseAlbedo(const Reference& reference, double tolerance);

    AlbedoValues operator()(dvec3 k, std::stop_token stop = {}) const;

  private:
    const Reference& reference_;
    std::shared_ptr<const FacetDistribution> distribution_;
    AdaptiveAlbedo albedo_;
};

}  // namespace nacre
