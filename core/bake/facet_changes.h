// What a brush's touch adds to g.
#pragma once

#include <vector>

#include "core/model/lobe.h"

namespace nacre {

// Facets close together, of masses of either sign.
class FacetChanges {
  public:
    explicit FacetChanges(const std::vector<Facet>& changes);

    // Sum of mass (h.k)+.
    double projected_area(dvec3 k) const;

  private:
    std::vector<double> x_, y_, z_;  // mass h
    std::vector<double> mass_;       // sign and size, to select the facets that k sees
    dvec3 moment_{0}, centre_{0};
    double radius_ = 0;
};

}  // namespace nacre
