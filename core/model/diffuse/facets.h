#pragma once

#include <glm/vec3.hpp>
#include <optional>

#include "core/model/diffuse/shader_diffuse.h"
#include "core/model/diffuse/shares.h"

namespace nacre {

// Ashikhmin et al. 2000, eq. 33 of Lambert's facets, and what light does from facet to facet; kd + ks <= 1.
struct FacetDiffuse {
    double kd = 0.5;
    double ks = 0.5;
    glm::dvec3 albedo{0.5};
    bool operator==(const FacetDiffuse&) const = default;

    static constexpr const char* name = "facets";
    static constexpr const char* label = "Matt facets";
    static constexpr const char* explanation =
        "Each facet is matt and lies as the highlight's facets do: clay and plaster look flat toward the "
        "light, "
        "and light that goes from facet to facet takes more of the colour (eq. 33).";
    static constexpr const char* note = "";
    static constexpr int file_version = 2;
    static constexpr auto parameters() { return share_parameters<FacetDiffuse>(); }

    static constexpr const char* formula =
        "rho = ks specular + kd (diffuse_albedo facets(k1, k2) V K1 K2/(N pi) + facet_scale facet_even (1 - "
        "Ef1) (1 - Ef2))";
    static constexpr bool reads_albedo = false;
    static constexpr bool matt_facets = true;
    ShaderDiffuse shader(glm::dvec3) const { return {albedo, kd, ks}; }
    std::optional<glm::dvec3> own_albedo() const { return albedo; }
    static FacetDiffuse of_albedo(glm::dvec3 albedo) { return {.albedo = albedo}; }

    std::optional<KindFault> fault() const { return share_fault(*this); }
    void make_room(double FacetDiffuse::*changed) { make_other_share_fit(*this, changed); }
};

}  // namespace nacre
