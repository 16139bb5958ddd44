// Do samples average to R, and is none of them worth more than its facet reflects?
#pragma once

#include <stop_token>

#include "core/bake/tables.h"

namespace nacre {

struct SamplingCheck {
    double weight =
        0;            // largest weight/F(k.h) - 1 of a specular sample; F that of the way which reflects most
    double mean = 0;  // largest |mean weight - R|
    int directions = 0;
};

// `tables` hold R.
SamplingCheck measure_sampling(const Tables& tables, std::stop_token stop);

}  // namespace nacre
