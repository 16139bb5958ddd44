#pragma once

#include <glm/common.hpp>
#include <tuple>

#include "core/model/fresnel/shader_fresnel.h"
#include "core/model/kinds/parameter.h"

namespace nacre {

// The same colour at every angle.
struct TintedFresnel {
    glm::dvec3 tint{0.8};
    bool operator==(const TintedFresnel&) const = default;

    static constexpr const char* name = "tinted";
    static constexpr const char* label = "Tinted";
    static constexpr const char* explanation = "The same colour at every angle.";
    static constexpr const char* note = "";
    static constexpr auto parameters() {
        return std::tuple{ColourParameter<TintedFresnel>{
            .member = &TintedFresnel::tint, .text = {"tint", "Tint", "Reflected colour."}, .bounds = {0, 1}}};
    }
    static constexpr const char* formula = "F = tint";
    static constexpr FresnelTables tables = FresnelTables::exact;
    ShaderFresnel shader() const { return {tint, {}}; }
    TintedFresnel beneath(double) const { return *this; }
    static TintedFresnel of_reflectance(const Reflectance& wanted) {
        return {glm::clamp(wanted(1), 0.0, 1.0)};
    }
};

}  // namespace nacre
