// Reflectances that look like the primaries of Rec. 709, so that a colour becomes a spectrum by a sum.
#pragma once

#include <array>
#include <glm/vec3.hpp>

namespace nacre {

// nm; in between every spectrum goes straight.
inline constexpr std::array<float, 6> primary_wavelengths = {380, 468, 507, 575, 602, 780};

// What a reflectance of linear red, green and blue is there: red r.x + green r.y + blue r.z. Each is between
// 0 and 1, the three add up to 1 everywhere, and under D65 each has its primary's colour (spectral_colour.h)
// to 1e-6, so colours from 0 to 1 stay between 0 and 1 at every wavelength. Of all that do they differ least
// from node to node; the method is that of Mallett and Yuksel, "Spectral primary decomposition for rendering
// with sRGB reflectance" (2019), sec. 3, on nodes as few as allow it.
inline constexpr std::array<glm::dvec3, 6> primary_spectra = {{{0, 0, 1},
                                                               {0.0251206956, 0.0127508281, 0.9621284763},
                                                               {0, 0.9361564454, 0.0638435546},
                                                               {0.0013106772, 0.9986893228, 0},
                                                               {0.9328994505, 0.0486797053, 0.0184208442},
                                                               {1, 0, 0}}};

}  // namespace nacre
