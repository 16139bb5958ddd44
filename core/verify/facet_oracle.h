// Facets that are matt themselves, without tables: what those are measured against.
#pragma once

#include "core/verify/facet_integral.h"
#include "core/verify/reference.h"
#include "core/verify/walk_estimate.h"

namespace nacre {

class FacetOracle {
  public:
    // `reference` is kept as a reference; its design has a diffuse model of matt facets.
    explicit FacetOracle(const Reference& reference);

    // N Q/(G1 G2) of shaders/shared/matt_facets.glsl, absolute error below 1e-6 without pictures.
    double product(dvec3 k1, dvec3 k2, const std::stop_token& stop = {}) const;

    // The diffuse term, 1/sr: its first bounce by integration, as far as it counts, and those after it by
    // random walks. 0 where either direction is not above the horizon. Throws BakeCancelled soon after a stop
    // is requested.
    WalkEstimate rho(dvec3 k1, dvec3 k2, const WalkEffort& effort = {.first = 1},
                     const std::stop_token& stop = {}) const;

  private:
    double area(dvec3 k) const;  // G
    WalkEstimate later_bounces(dvec3 k1, dvec3 k2, const WalkEffort& effort,
                               const std::stop_token& stop) const;

    const Reference& reference_;
    AdaptiveProduct product_;
};

}  // namespace nacre
