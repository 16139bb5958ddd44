#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <tuple>

#include "core/model/diffuse/albedo_text.h"
#include "core/model/diffuse/shader_diffuse.h"

namespace nacre {

// Ashikhmin et al. 2000, eq. 28 to 30.
struct CoupledDiffuse {
    glm::dvec3 albedo{0.5};
    bool operator==(const CoupledDiffuse&) const = default;

    static constexpr const char* name = "coupled";
    static constexpr const char* label = "Coupled";
    static constexpr const char* explanation =
        "The diffuse part takes exactly what the highlight leaves, so it fades toward grazing angles as "
        "lacquer does: "
        "albedo c (1 \u2212 R(k1))(1 \u2212 R(k2)) (eq. 28).";
    static constexpr const char* note = "";
    static constexpr auto parameters() {
        return std::tuple{ColourParameter<CoupledDiffuse>{
            .member = &CoupledDiffuse::albedo, .text = diffuse_albedo_text, .bounds = {0, 1}}};
    }

    static constexpr const char* formula =
        "rho = specular + coupling diffuse_albedo max(0, 1 - R(k1)) max(0, 1 - R(k2))";
    static constexpr bool reads_albedo = true;
    static constexpr bool matt_facets = false;
    ShaderDiffuse shader(glm::dvec3) const { return {.albedo = albedo}; }
    std::optional<glm::dvec3> own_albedo() const { return albedo; }
    static CoupledDiffuse of_albedo(glm::dvec3 albedo) { return {albedo}; }
};

}  // namespace nacre
