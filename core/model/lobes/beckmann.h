#pragma once

#include <memory>
#include <tuple>

#include "core/model/lobes/shader_lobe.h"
#include "core/model/lobes/widths.h"

namespace nacre {

class LobeModel;

// Walter et al. 2007, eq. 25.
struct BeckmannLobe {
    double alpha_x = 0.2;
    double alpha_y = 0.2;
    bool operator==(const BeckmannLobe&) const = default;

    static constexpr const char* name = "beckmann";
    static constexpr const char* label = "Beckmann";
    static constexpr const char* explanation =
        "Like the Gaussian, with the theory of rough random surfaces behind it.\n"
        "p ~ exp(\u2212tan\u00b2\u03b8 (cos\u00b2\u03c6/\u03b1x\u00b2 + "
        "sin\u00b2\u03c6/\u03b1y\u00b2))/cos\u2074\u03b8 (Walter 2007, eq. 25)";
    static constexpr auto parameters() {
        return std::tuple{roughness_x_parameter<BeckmannLobe>(), roughness_y_parameter<BeckmannLobe>()};
    }

    static constexpr WidthMembers<BeckmannLobe> width_members{&BeckmannLobe::alpha_x, &BeckmannLobe::alpha_y};
    static BeckmannLobe of_widths(glm::dvec2 widths) {
        return {finite_width(widths.x), finite_width(widths.y)};
    }

    double period() const { return period_of_widths(alpha_x, alpha_y); }
    bool reaches_below() const { return false; }
    const char* table_kind() const { return name; }
    const char* formula() const { return "exp(-((x i/z)^2 + (y j/z)^2))/z^4"; }
    ShaderLobe shader() const { return {.inverse_width = {1 / alpha_x, 1 / alpha_y}}; }
    std::shared_ptr<const LobeModel> model() const;
    ExtremeClaims extreme_claims() const { return claims_of_widths(alpha_x, alpha_y); }
};

}  // namespace nacre
