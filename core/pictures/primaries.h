#pragma once

#include <array>
#include <glm/mat3x3.hpp>
#include <optional>

namespace nacre {

// Takes linear colours of other primaries to Rec. 709's. `xy`: red, green, blue and white, as CIE x and y.
// Nothing where they are Rec. 709's already, or make no colours. White stays white.
std::optional<glm::dmat3> to_rec709(const std::array<double, 8>& xy);

}  // namespace nacre
