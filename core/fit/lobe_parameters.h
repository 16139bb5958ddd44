// A lobe as six free numbers, so that a step of any size leaves it a lobe.
#pragma once

#include <array>

#include "core/fit/lobe_terms.h"

namespace nacre {

// log weight; the slopes Nx/Nz and Ny/Nz; log L11, L21, log L22 of the Cholesky factor L of A - I, which
// keeps widths below 1 (Cycles allows no others).
using LobeParameters = std::array<double, 6>;

// What a fit keeps each lobe within. A weight above 4 makes more light than there is, and a lobe of no more
// than a speck's width would be fitted to single pairs.
inline constexpr double weight_max = 4, slope_max = 8, alpha_min = 1e-3;
void keep_within(LobeParameters& parameters);

LobeFrame frame_of(const LobeParameters& parameters);

// Widths are cut to what the parameters can say, and to no less than alpha_min.
LobeParameters parameters_of(const LobeFrame& frame);

// Derivatives of anything by the members of LobeFrame, each on its own; the weight's by its logarithm.
struct FrameGradient {
    double log_weight = 0;
    glm::dvec3 N{0}, X{0}, Y{0};
    double a11 = 0, a12 = 0, a22 = 0;

    FrameGradient& operator+=(const FrameGradient& other);
};

// The same by the parameters.
LobeParameters by_parameters(const LobeParameters& parameters, const FrameGradient& by_frame);

}  // namespace nacre
