#include "app/preview/factor_scale.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/image/srgb.h"
#include "core/paint/colour_map.h"
#include "core/paint/density_picture.h"

namespace nacre {
namespace {

constexpr double decades = 1e3;

}  // namespace

FactorScale factor_scale(Term factor, const Tables& tables, double exposure) {
    FactorScale scale;
    if (factor == Term::density) scale.high = peak_density(*tables.distribution);
    if (factor == Term::fresnel) scale.coloured = true;
    if (factor == Term::inverse_areas) {
        scale.logarithmic = true;
        const double g = tables.shading.direction({0, 0, 1}).g;
        scale.low = 1 / (g * g);
        scale.high = decades * scale.low;
    }
    const double less = std::exp2(-exposure);
    scale.low *= less;
    scale.high *= less;
    return scale;
}

FactorScale common_scale(const FactorScale& a, const FactorScale& b) {
    FactorScale both = a;
    both.low = std::min(a.low, b.low);
    both.high = std::max(a.high, b.high);
    return both;
}

glm::u8vec3 colour_of(const FactorScale& scale, double place) {
    if (!scale.coloured) return inferno(place);
    return glm::u8vec3(static_cast<std::uint8_t>(std::lround(255 * srgb_encoded(place))));
}

ScaleEnds ends_in_words(Term factor, const FactorScale& scale) {
    const char* unit = factor == Term::density ? " sr\u207b\u00b9" : "";
    return {fmt::format("{:.3g}", scale.low), fmt::format("{:.3g}{}", scale.high, unit)};
}

}  // namespace nacre
