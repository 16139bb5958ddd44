#pragma once

#include <tuple>

#include "core/model/coat/shader_coat.h"

namespace nacre {

struct NoCoat {
    bool operator==(const NoCoat&) const = default;

    static constexpr const char* name = "none";
    static constexpr const char* label = "None";
    static constexpr const char* explanation = "Light meets the facets in air.";
    static constexpr auto parameters() { return std::tuple{}; }

    static constexpr const char* formula = "";
    static constexpr const char* area_formula = "";
    static constexpr bool covers = false;
    ShaderCoat shader() const { return {}; }
};

}  // namespace nacre
