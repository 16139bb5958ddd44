#pragma once

#include <algorithm>
#include <memory>
#include <tuple>

#include "core/model/lobes/shader_lobe.h"
#include "core/model/lobes/widths.h"

namespace nacre {

class LobeModel;

// Ashikhmin et al. 2000, eq. 35.
struct InverseGaussianLobe {
    double sigma = 0.5;
    bool operator==(const InverseGaussianLobe&) const = default;

    static constexpr const char* name = "inverse_gaussian";
    static constexpr const char* label = "Inverse Gaussian";
    static constexpr const char* explanation =
        "Velvet: facets stand upright like fibres, dark when seen from above, glowing at the rim.\n"
        "p ~ exp(\u2212cot\u00b2\u03b8/\u03c3\u00b2) (Ashikhmin 2000, eq. 35)";
    static constexpr auto parameters() {
        return std::tuple{width_parameter(
            &InverseGaussianLobe::sigma,
            {"sigma", "Width",
             "\u03c3: how far the fibres lean from upright, as a slope: small widths leave only "
             "the rim glowing. p ~ exp(\u2212cot\u00b2\u03b8/\u03c3\u00b2)."})};
    }

    static constexpr WidthMembers<InverseGaussianLobe> width_members{&InverseGaussianLobe::sigma,
                                                                     &InverseGaussianLobe::sigma, true};
    static InverseGaussianLobe of_widths(glm::dvec2 widths) {
        return {std::max(finite_width(widths.x), finite_width(widths.y))};
    }

    double period() const { return 0; }
    bool reaches_below() const { return false; }
    const char* table_kind() const { return name; }
    const char* formula() const { return "exp(-(z i)^2/(x^2 + y^2)): 0 at x = y = 0"; }
    ShaderLobe shader() const { return {.inverse_width = glm::dvec2(1 / sigma)}; }
    std::shared_ptr<const LobeModel> model() const;
};

}  // namespace nacre
