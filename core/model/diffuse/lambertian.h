#pragma once

#include <glm/vec3.hpp>
#include <optional>

#include "core/model/diffuse/shader_diffuse.h"
#include "core/model/diffuse/shares.h"

namespace nacre {

// Ashikhmin et al. 2000, eq. 27; kd + ks <= 1.
struct LambertianDiffuse {
    double kd = 0.5;
    double ks = 0.5;
    glm::dvec3 albedo{0.5};
    bool operator==(const LambertianDiffuse&) const = default;

    static constexpr const char* name = "lambertian";
    static constexpr const char* label = "Lambertian";
    static constexpr const char* explanation = "Fixed shares: kd albedo/\u03c0 + ks specular (eq. 27).";
    static constexpr const char* note = "";
    static constexpr auto parameters() { return share_parameters<LambertianDiffuse>(); }

    static constexpr const char* formula = "rho = ks specular + kd diffuse_albedo/pi";
    static constexpr bool reads_albedo = false;
    static constexpr bool matt_facets = false;
    ShaderDiffuse shader(glm::dvec3) const { return {albedo, kd, ks}; }
    std::optional<glm::dvec3> own_albedo() const { return albedo; }
    static LambertianDiffuse of_albedo(glm::dvec3 albedo) { return {.albedo = albedo}; }

    std::optional<KindFault> fault() const { return share_fault(*this); }
    void make_room(double LambertianDiffuse::*changed) { make_other_share_fit(*this, changed); }
};

}  // namespace nacre
