#pragma once

#include <memory>
#include <tuple>

#include "core/model/lobes/shader_lobe.h"
#include "core/model/lobes/widths.h"

namespace nacre {

class LobeModel;

// Walter et al. 2007, eq. 33; anisotropic as in Heitz 2014, eq. 85.
struct GgxLobe {
    double alpha_x = 0.2;
    double alpha_y = 0.2;
    bool operator==(const GgxLobe&) const = default;

    static constexpr const char* name = "ggx";
    static constexpr const char* label = "GGX";
    static constexpr const char* explanation =
        "A sharp core with a long haze around it; today's common choice for metals.\n"
        "p ~ 1/(x\u00b2/\u03b1x\u00b2 + y\u00b2/\u03b1y\u00b2 + z\u00b2)\u00b2 of the facet normal "
        "(x, y, z) (Walter 2007, eq. 33; Heitz 2014, eq. 85)";
    static constexpr auto parameters() {
        return std::tuple{roughness_x_parameter<GgxLobe>(), roughness_y_parameter<GgxLobe>()};
    }

    static constexpr WidthMembers<GgxLobe> width_members{&GgxLobe::alpha_x, &GgxLobe::alpha_y};
    static GgxLobe of_widths(glm::dvec2 widths) { return {finite_width(widths.x), finite_width(widths.y)}; }

    double period() const { return period_of_widths(alpha_x, alpha_y); }
    bool reaches_below() const { return false; }
    const char* table_kind() const { return name; }
    const char* formula() const { return "1/((x i)^2 + (y j)^2 + z^2)^2"; }
    ShaderLobe shader() const { return {.inverse_width = {1 / alpha_x, 1 / alpha_y}}; }
    std::shared_ptr<const LobeModel> model() const;
    ExtremeClaims extreme_claims() const { return claims_of_widths(alpha_x, alpha_y); }
};

}  // namespace nacre
