// Multiple bounces by random walks with the exact g: what the tables are measured against.
#pragma once

#include <stop_token>

#include "core/verify/reference.h"
#include "core/verify/walk_estimate.h"

namespace nacre {

class BounceOracle {
  public:
    // `reference` is kept as a reference. Of a design whose masking is not that of the walks, what comes back
    // is scaled to the light that this masking leaves, 1 - E.
    explicit BounceOracle(const Reference& reference);

    // rho of the bounces that count, 1/sr, of intensity 1; 0 where either direction is not above the horizon.
    // Throws BakeCancelled soon after a stop is requested.
    WalkEstimate rho(dvec3 k1, dvec3 k2, const WalkEffort& effort = {},
                     const std::stop_token& stop = {}) const;

    // The part of the light from k1 that comes back after the bounces that count.
    WalkEstimate albedo(dvec3 k1, const WalkEffort& effort = {}, const std::stop_token& stop = {}) const;

  private:
    // Of the bounces that count: before(walks, scores) each of them, leave(walk, scores) where light comes
    // out.
    template <class Before, class Leave>
    WalkEstimate over_bounces(dvec3 k1, const WalkEffort& effort, const std::stop_token& stop,
                              const Before& before, const Leave& leave) const;
    // Without retro-reflection.
    WalkEstimate forward_rho(dvec3 k1, dvec3 k2, const WalkEffort& effort, const std::stop_token& stop) const;
    WalkEstimate forward_albedo(dvec3 k1, const WalkEffort& effort, const std::stop_token& stop) const;
    dvec3 reflectance(dvec3 h, double cosine) const;
    double rest(dvec3 k, int masking, const std::stop_token& stop) const;
    double scale(dvec3 k, const std::stop_token& stop) const;

    const Reference& reference_;
    FacetWalk walk_;
};

}  // namespace nacre
