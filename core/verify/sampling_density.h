// Are sampled directions as dense as the pdf says?
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <stop_token>

#include "core/bake/tables.h"

namespace nacre {

struct SamplingDensity {
    double surprise =
        0;  // largest -log10 of the probability of counts so far from the pdf, all directions together
    int directions = 0;
    int samples = 0;  // from each direction
    int bins = 0;     // all directions together
};

// k2 from one k1; nothing for a sample below the horizon.
using DirectionSource = std::function<std::optional<dvec3>(Random&)>;

// Chi-square tests of sampled directions, every term of the BRDF together, against Brdf::pdf(): bins of k2
// that are about equally likely however narrow p is, their shares integrated over the lobes' facets and the
// cosine, and one more for what is lost below the horizon. `source_at` gives the sampler at k1: Brdf's own
// where it is none.
SamplingDensity measure_sampling_density(const std::shared_ptr<const Tables>& tables, std::stop_token stop,
                                         const std::function<DirectionSource(dvec3 k1)>& source_at = {},
                                         int directions = 6);

}  // namespace nacre
