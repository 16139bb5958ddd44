#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <tuple>

#include "core/model/diffuse/albedo_text.h"
#include "core/model/diffuse/shader_diffuse.h"

namespace nacre {

// Half of the light by the highlight, half by Lambert's law.
struct EvenDiffuse {
    glm::dvec3 albedo{0.5};
    bool operator==(const EvenDiffuse&) const = default;

    static constexpr const char* name = "evenly";
    static constexpr const char* label = "Evenly";
    static constexpr const char* explanation = "Half by the highlight, half by Lambert's law.";
    static constexpr const char* note = "";
    static constexpr auto parameters() {
        return std::tuple{ColourParameter<EvenDiffuse>{
            .member = &EvenDiffuse::albedo, .text = diffuse_albedo_text, .bounds = {0, 1}}};
    }
    static constexpr const char* formula = "rho = specular/2 + diffuse_albedo/(2 pi)";
    static constexpr bool reads_albedo = false;
    static constexpr bool matt_facets = false;
    ShaderDiffuse shader(glm::dvec3) const { return {albedo, 0.5, 0.5}; }
    std::optional<glm::dvec3> own_albedo() const { return albedo; }
    static EvenDiffuse of_albedo(glm::dvec3 albedo) { return {albedo}; }
};

}  // namespace nacre
