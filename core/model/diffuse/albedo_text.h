// The words of the parameter that most diffuse models have.
#pragma once

#include "core/model/kinds/parameter.h"

namespace nacre {

inline constexpr ParameterText diffuse_albedo_text{
    "albedo", "Albedo",
    "Directional albedo of the diffuse part: how much of the light that reaches it comes back, per colour. "
    "Linear values; the swatch picks as displayed.",
    "diffuse_albedo"};

}  // namespace nacre
