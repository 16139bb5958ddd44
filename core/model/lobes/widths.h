// The widths that lobes share.
#pragma once

#include <cmath>
#include <glm/vec2.hpp>

#include "core/base/limits.h"
#include "core/model/kinds/extreme_claims.h"
#include "core/model/kinds/parameter.h"

namespace nacre {

// Which members of a lobe are its widths along x and y, as slopes; the same member twice for a lobe with one
// width, none for a lobe that has none. An inverse width is that of 1/slope: the lobe is concentrated at its
// horizon.
template <class Lobe>
struct WidthMembers {
    double Lobe::*x = nullptr;
    double Lobe::*y = nullptr;
    bool inverse = false;
};

// The width that a lobe without widths converts to: a polished surface's.
inline constexpr double default_width = 0.2;

inline double finite_width(double width) { return std::isinf(width) ? 1 : width; }

template <class Lobe>
constexpr NumberParameter<Lobe> width_parameter(double Lobe::*member, ParameterText text,
                                                bool may_be_infinite = false) {
    return {.member = member,
            .text = text,
            .bounds = {limits::width_min, limits::width_max},
            .slider = {.ends = {1e-3, 10}, .format = "%.4g", .logarithmic = true},
            .may_be_infinite = may_be_infinite};
}

// GGX and Beckmann call their widths roughness.
template <class Lobe>
constexpr NumberParameter<Lobe> roughness_x_parameter() {
    return width_parameter(
        &Lobe::alpha_x,
        {"alpha_x", "Roughness x",
         "\u03b1x, the roughness along x (the tangent) as a slope: 0.01 is polished, 0.1 satin, 1 "
         "rough. The slopes of the surface spread as far as \u03b1x; the formula stands at the "
         "lobe's kind."});
}

template <class Lobe>
constexpr NumberParameter<Lobe> roughness_y_parameter() {
    return width_parameter(
        &Lobe::alpha_y,
        {"alpha_y", "Roughness y",
         "\u03b1y, the roughness along y (the bitangent). Unequal ones stretch the highlight across "
         "the rougher direction: brushed metal, hair, cloth."});
}

// Of a lobe with long tails that is much wider one way: R turns within a thousandth of a degree of azimuth.
inline ExtremeClaims claims_of_widths(double x, double y) {
    const double narrow = std::fmin(x, y), wide = std::fmax(x, y);
    if (x == y) return {};
    const bool needle = narrow < 1e-3 && wide > 10 && std::isfinite(wide);
    if (needle || (wide > 1e4 && narrow > 1e-3)) return {.albedo = 0.3};
    if (narrow < 1e-3) return {.albedo = layer_albedo_claim};
    return {};
}

// Period in degrees of a lobe that is symmetric in x and in y: 0 when it is round.
inline double period_of_widths(double x, double y) { return x == y ? 0 : 180; }

}  // namespace nacre
