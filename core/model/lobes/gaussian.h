#pragma once

#include <memory>
#include <tuple>

#include "core/model/lobes/shader_lobe.h"
#include "core/model/lobes/widths.h"

namespace nacre {

class LobeModel;

// Ashikhmin et al. 2000, eq. 34. Slopes; infinity makes a cylinder along the other axis.
struct GaussianLobe {
    double sigma_x = 0.2;
    double sigma_y = 0.2;
    bool operator==(const GaussianLobe&) const = default;

    static constexpr const char* name = "gaussian";
    static constexpr const char* label = "Gaussian";
    static constexpr const char* explanation =
        "Facets cluster around the normal; the highlight of most polished and brushed surfaces. An infinite "
        "width makes a cylinder, as threads or grooves do.\n"
        "p ~ exp(\u2212tan\u00b2\u03b8 (cos\u00b2\u03c6/\u03c3x\u00b2 + sin\u00b2\u03c6/\u03c3y\u00b2)) "
        "(Ashikhmin 2000, eq. 34)";
    static constexpr auto parameters() {
        return std::tuple{
            width_parameter(
                &GaussianLobe::sigma_x,
                {"sigma_x", "Width x",
                 "\u03c3x, the lobe's width along x (the tangent) as a slope: 0.01 is polished, 0.1 satin, "
                 "1 rough. Facets of this slope are 1/e as frequent as the middle: p ~ "
                 "exp(\u2212(slope/\u03c3x)\u00b2)."},
                true),
            width_parameter(
                &GaussianLobe::sigma_y,
                {"sigma_y", "Width y",
                 "\u03c3y, the width along y (the bitangent). Unequal widths stretch the highlight across "
                 "the wider one: brushed metal, hair, cloth. p ~ exp(\u2212(slope/\u03c3y)\u00b2)."},
                true)};
    }

    static constexpr WidthMembers<GaussianLobe> width_members{&GaussianLobe::sigma_x, &GaussianLobe::sigma_y};
    static GaussianLobe of_widths(glm::dvec2 widths) { return {widths.x, widths.y}; }

    double period() const { return period_of_widths(sigma_x, sigma_y); }
    bool reaches_below() const { return false; }
    const char* table_kind() const { return name; }
    const char* formula() const { return "exp(-((x i/z)^2 + (y j/z)^2))"; }
    ShaderLobe shader() const { return {.inverse_width = {1 / sigma_x, 1 / sigma_y}}; }
    std::shared_ptr<const LobeModel> model() const;
};

}  // namespace nacre
