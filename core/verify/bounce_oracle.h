// Multiple bounces by random walks with the exact g: what the tables are measured against.
#pragma once

#include <cstdint>
#include <stop_token>

#include "core/verify/reference.h"

namespace nacre {

// A mean over walks and the standard error of it, each colour.
struct WalkEstimate {
    dvec3 mean{0};
    dvec3 error{0};
};

struct WalkEffort {
    int walks = 65536;
    std::uint64_t seed = 1;
    int first = 2, last = 1 << 20;  // bounces that count; the first is that of the walks' own masking
};

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
    // Without retro-reflection.
    WalkEstimate forward_rho(dvec3 k1, dvec3 k2, const WalkEffort& effort, const std::stop_token& stop) const;
    WalkEstimate forward_albedo(dvec3 k1, const WalkEffort& effort, const std::stop_token& stop) const;
    dvec3 reflectance(dvec3 h, double cosine) const;
    double rest(dvec3 k, int masking, const std::stop_token& stop) const;
    double scale(dvec3 k, const std::stop_token& stop) const;

    const Reference& reference_;
    bool scaled_;
};

}  // namespace nacre
