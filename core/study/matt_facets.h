// Facets that are matt themselves, by direct integration (Ashikhmin 2000, eq. 33).
#pragma once

#include <cstddef>
#include <vector>

#include "core/model/facet_distribution.h"

namespace nacre {

class MattFacets {
  public:
    // Sums over about so many facets a lobe.
    explicit MattFacets(const FacetDistribution& p, std::size_t count = 8192);

    // rho of white facets: P1 P2/(N c1 c2) times the integral of (k1.h)+ (k2.h)+ p/pi, with P = N c/g. Light
    // that goes from facet to facet is left out, as in the paper. 1/sr; unit vectors.
    double brdf(dvec3 k1, dvec3 k2) const;

  private:
    std::vector<double> x_, y_, z_, mass_;
    double mean_cosine_ = 0;
};

}  // namespace nacre
