#pragma once

#include <glm/common.hpp>
#include <tuple>

#include "core/model/fresnel/shader_fresnel.h"
#include "core/model/kinds/parameter.h"

namespace nacre {

// Schlick 1994 (Ashikhmin et al. 2000, eq. 31).
struct SchlickFresnel {
    glm::dvec3 f0{0.05};
    bool operator==(const SchlickFresnel&) const = default;

    static constexpr const char* name = "schlick";
    static constexpr const char* label = "Schlick";
    static constexpr const char* explanation =
        "One colour f0, rising to white at grazing angles: F = f0 + (1 \u2212 f0)(1 \u2212 k\u00b7h)\u2075 "
        "(eq. 31).";
    static constexpr const char* note = "";
    static constexpr auto parameters() {
        return std::tuple{ColourParameter<SchlickFresnel>{
            .member = &SchlickFresnel::f0,
            .text =
                {"f0", "f0",
                 "Reflected colour when looking straight at a facet. About 0.04 (dark grey) for plastics and "
                 "glass, strong and coloured for metals. F = f0 + (1 \u2212 f0)(1 \u2212 k\u00b7h)\u2075. "
                 "Linear "
                 "values; the swatch picks as displayed."},
            .bounds = {0, 1}}};
    }

    static constexpr const char* formula = "F = f0 + (1 - f0) (1 - c)^5";
    static constexpr FresnelTables tables = FresnelTables::linear;
    ShaderFresnel shader() const { return {f0, {}}; }
    SchlickFresnel beneath(double above) const { return {reflectance_beneath(f0, above)}; }
    static SchlickFresnel of_reflectance(const Reflectance& wanted) {
        return {glm::clamp(wanted(1), 0.0, 1.0)};
    }
};

}  // namespace nacre
