// Numbers as colours that the eye ranks as the numbers are.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

namespace nacre {

// `inferno` of matplotlib (van der Walt and Smith 2015), even in perceived lightness from black over violet
// and orange to pale yellow, by the polynomials of Zucker (2019), which keep within 0.02 of it. Takes [0, 1],
// clamped; returns 8-bit sRGB.
glm::u8vec3 inferno(double t);

}  // namespace nacre
