// From a reflectance at each wavelength to a colour. The one place that decides on observer, white,
// adaptation and gamut:
//
//   observer    CIE 1931, 2 degrees
//   light       D65
//   white       D65 too, as Rec. 709's: what reflects 1 everywhere is (1, 1, 1)
//   adaptation  none
//   primaries   Rec. 709, linear
//   gamut       a channel outside 0 to 1 is clipped, after the integration
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <vector>

namespace nacre {

inline constexpr double spectrum_begin = 380;  // nm
inline constexpr double spectrum_end = 780;

// A wavelength of the rule that integrates a spectrum, nm, and what a reflectance there adds to each colour.
struct SpectralNode {
    double wavelength;
    glm::dvec3 weight;
};

// The trapezoidal rule with that many steps a nanometre, at least 1. The weights of each colour add up to 1;
// some are negative.
std::vector<SpectralNode> spectral_nodes(int steps);

// A colour inside the gamut, and how far it was outside.
struct GamutColour {
    glm::dvec3 colour;
    double clipped;
};
GamutColour clip_to_gamut(glm::dvec3 colour);

// The above in words, for the window.
inline constexpr const char* spectral_colour_rule =
    "Integrated from 380 to 780 nm: CIE 1931 observer, light and white D65, no adaptation, Rec. 709, clipped "
    "to 0 to 1.";

}  // namespace nacre
