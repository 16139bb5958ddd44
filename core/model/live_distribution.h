// p of a design that is being edited: what has not changed since the last call is reused, so that a slider
// costs microseconds and a dab of the brush about a millisecond.
#pragma once

#include <optional>

#include "core/model/facet_distribution.h"

namespace nacre {

class LiveDistribution {
  public:
    // Brings p up to date; null where the design has none (no facets, or none that face up on the whole).
    std::shared_ptr<const FacetDistribution> of(const Distribution& distribution);

    // Rises whenever p changes.
    int revision() const { return revision_; }

  private:
    std::shared_ptr<const LobeModel> model_of(const Layer& layer, std::size_t index) const;

    std::optional<Distribution> design_;                    // that facets_ was made from
    std::vector<std::shared_ptr<const LobeModel>> models_;  // of its layers; null for those left out
    std::shared_ptr<const FacetDistribution> facets_;
    int revision_ = 0;
};

}  // namespace nacre
