#pragma once

#include <fmt/core.h>

#include <algorithm>
#include <glm/vec3.hpp>
#include <optional>
#include <tuple>

#include "core/model/diffuse/albedo_text.h"
#include "core/model/diffuse/shader_diffuse.h"
#include "core/model/kinds/kind.h"

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
    static constexpr auto parameters() {
        constexpr Range share{0, 1};
        return std::tuple{
            NumberParameter<LambertianDiffuse>{
                .member = &LambertianDiffuse::kd,
                .text = {"kd", "Diffuse kd",
                         "Share of the diffuse part: kd albedo/\u03c0. kd + ks stays at most 1."},
                .bounds = share,
                .slider = {.ends = share}},
            NumberParameter<LambertianDiffuse>{
                .member = &LambertianDiffuse::ks,
                .text = {"ks", "Specular ks",
                         "Share of the highlight: ks times the specular term. kd + ks stays at most 1."},
                .bounds = share,
                .slider = {.ends = share}},
            ColourParameter<LambertianDiffuse>{
                .member = &LambertianDiffuse::albedo, .text = diffuse_albedo_text, .bounds = share}};
    }

    static constexpr const char* formula = "rho = ks specular + kd diffuse_albedo/pi";
    static constexpr bool reads_albedo = false;
    ShaderDiffuse shader(glm::dvec3) const { return {albedo, kd, ks}; }
    std::optional<glm::dvec3> own_albedo() const { return albedo; }
    static LambertianDiffuse of_albedo(glm::dvec3 albedo) { return {.albedo = albedo}; }

    std::optional<KindFault> fault() const {
        constexpr double rounding = 1e-9;
        if (kd + ks <= 1 + rounding) return {};
        return KindFault{"", "kd + ks must not exceed 1, or energy is created",
                         fmt::format("{} + {} = {}", kd, ks, kd + ks)};
    }

    // After one share was changed by hand: the other one makes room.
    void make_room(double LambertianDiffuse::*changed) {
        if (changed == &LambertianDiffuse::kd) ks = std::min(ks, 1 - kd);
        if (changed == &LambertianDiffuse::ks) kd = std::min(kd, 1 - ks);
    }
};

}  // namespace nacre
