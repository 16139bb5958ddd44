// The BRDF of many pairs of directions at once.
#pragma once

#include <span>

#include "core/model/shading.h"

namespace nacre {

// rho[i] = rho(k1[i], k2[i]), 1/sr, in float, with SIMD vectors as wide as the processor has. Unit
// vectors in the local frame; 0 where either is not above the horizon, and symmetric in k1 and k2 to the last
// bit. All three hold equally many.
void evaluate_pairs(const Shading<float>& shading, std::span<const glm::vec3> k1,
                    std::span<const glm::vec3> k2, std::span<glm::vec3> rho);

}  // namespace nacre
