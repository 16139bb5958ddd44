#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <tuple>

#include "core/model/diffuse/shader_diffuse.h"

namespace nacre {

struct NoDiffuse {
    bool operator==(const NoDiffuse&) const = default;

    static constexpr const char* name = "none";
    static constexpr const char* label = "None";
    static constexpr const char* explanation =
        "All light comes back by one mirror reflection, or not at all.";
    static constexpr const char* note = "";
    static constexpr auto parameters() { return std::tuple{}; }

    static constexpr const char* formula = "rho = specular";
    static constexpr bool reads_albedo = false;
    static constexpr bool matt_facets = false;
    ShaderDiffuse shader(glm::dvec3) const { return {}; }
    std::optional<glm::dvec3> own_albedo() const { return {}; }
    static NoDiffuse of_albedo(glm::dvec3) { return {}; }
};

}  // namespace nacre
