// Are samples worth what the albedo says, and none more than its facet reflects?
#pragma once

#include <memory>
#include <stop_token>

#include "core/bake/tables.h"
#include "core/design/design.h"

namespace nacre {

struct SamplingCheck {
    double weight = 0;  // largest weight/F(k.h) - 1 of a specular sample
    double mean = 0;    // largest |mean weight - R|
};

// `tables` are those of the design, R included.
SamplingCheck measure_sampling(const Design& design, std::shared_ptr<const Tables> tables,
                               std::stop_token stop);

}  // namespace nacre
