// How a factor of the BRDF becomes colours.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <string>

#include "core/bake/tables.h"
#include "core/shading/term.h"

namespace nacre {

struct FactorScale {
    double low = 0;  // black; of a logarithmic scale its first value
    double high = 1;
    bool logarithmic = false;
    bool coloured =
        false;  // the factor has a colour of its own; otherwise `inferno` (core/paint/colour_map.h)
};

// P and F up to 1; p up to its peak; 1/(g g) from its value at the normal over three decades. Two doublings
// of exposure leave a quarter of the range.
FactorScale factor_scale(Term factor, const Tables& tables, double exposure);

// The range that holds both, so that two pictures can be compared.
FactorScale common_scale(const FactorScale& a, const FactorScale& b);

// sRGB at a place of the scale in [0, 1], as shaders/develop.frag shows it.
glm::u8vec3 colour_of(const FactorScale& scale, double place);

// Both ends of the scale in words, with the unit.
struct ScaleEnds {
    std::string low, high;
};
ScaleEnds ends_in_words(Term factor, const FactorScale& scale);

}  // namespace nacre
