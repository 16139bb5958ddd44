#pragma once

#include <tuple>

#include "core/model/fresnel/shader_fresnel.h"

namespace nacre {

struct NoFresnel {
    bool operator==(const NoFresnel&) const = default;

    static constexpr const char* name = "none";
    static constexpr const char* label = "None";
    static constexpr const char* explanation = "Every facet is a perfect mirror, F = 1: to study p alone.";
    static constexpr const char* note = "Every facet is a perfect mirror (F = 1).";
    static constexpr auto parameters() { return std::tuple{}; }

    static constexpr const char* formula = "F = 1";
    static constexpr FresnelTables tables = FresnelTables::none;
    ShaderFresnel shader() const { return {}; }
    NoFresnel beneath(double) const { return {}; }
    static NoFresnel of_reflectance(const Reflectance&) { return {}; }
};

}  // namespace nacre
