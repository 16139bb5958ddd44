// Designs at the edge of what can be asked for, and what is expected of each.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/design/design.h"

namespace nacre {

struct ExtremeCase {
    std::string group;
    std::string name;
    Design design;
    std::string refusal =
        {};  // part of what the bake refuses it with; empty: it must bake and be finite and non-negative
    std::optional<Design> same_rho = {};  // a design whose BRDF must be the same
    double area_claim = ExtremeClaims{}.area;
    double albedo_claim = ExtremeClaims{}.albedo;
};

// In the order of their groups.
std::vector<ExtremeCase> extreme_cases();

}  // namespace nacre
