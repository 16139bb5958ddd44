// Mirror planes and roundness of p, found from the layers' parameters (Ashikhmin 2000, sec. 5.2).
#pragma once

#include "core/model/layer.h"

namespace nacre {

enum class Symmetry { isotropic, quarter, half, none };  // in the order of SYMMETRY_* of the shader

struct DistributionSymmetry {
    Symmetry symmetry = Symmetry::none;
    double axis = 0;  // degrees: azimuth of a mirror plane (quarter and half)

    bool operator==(const DistributionSymmetry&) const = default;
};

// Never claims a symmetry that p does not have, or that the layers' tints do not share: R has it too. Angles
// count as equal within 1e-9 degrees.
DistributionSymmetry find_symmetry(const Distribution& distribution);

const char* name_of(Symmetry symmetry);

}  // namespace nacre
