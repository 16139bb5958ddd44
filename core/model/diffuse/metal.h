#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <tuple>

#include "core/model/diffuse/shader_diffuse.h"

namespace nacre {

// The metal of Ashikhmin et al. 2000: ones of eq. 30 become f0, and the albedo is f0.
struct MetalDiffuse {
    bool operator==(const MetalDiffuse&) const = default;

    static constexpr const char* name = "metal";
    static constexpr const char* label = "Metal";
    static constexpr const char* explanation =
        "Light that bounces between facets, in the metal's own colour.";
    static constexpr const char* note = "Takes its colour from the reflection's f0.";
    static constexpr auto parameters() { return std::tuple{}; }

    static constexpr const char* formula =
        "rho = specular + coupling diffuse_albedo max(0, diffuse_albedo - R(k1)) max(0, diffuse_albedo - "
        "R(k2))";
    static constexpr bool reads_albedo = true;
    static constexpr bool matt_facets = false;
    ShaderDiffuse shader(glm::dvec3 f0) const { return {.albedo = f0}; }
    std::optional<glm::dvec3> own_albedo() const { return {}; }
    static MetalDiffuse of_albedo(glm::dvec3) { return {}; }
};

}  // namespace nacre
