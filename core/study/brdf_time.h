// What one BRDF costs beside Ward's, on the machine that this runs on.
#pragma once

#include <stop_token>

namespace nacre {

struct BrdfTimes {
    double ward = 0;     // seconds a pair of directions; all are medians of many runs in turn
    double call = 0;     // ours, one call a pair, over Ward's called alike
    double batch = 0;    // ours, many pairs at once, over Ward's in a loop
    double density = 0;  // p's part of our call
};

// Gaussian (0.1, 1), Schlick's factor in three colours, in float, half of the pairs about the highlight.
BrdfTimes time_brdf(const std::stop_token& stop);

}  // namespace nacre
