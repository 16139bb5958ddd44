#pragma once

#include <algorithm>
#include <cmath>
#include <glm/vec3.hpp>
#include <tuple>
#include <utility>
#include <vector>

#include "core/base/limits.h"
#include "core/model/fresnel/shader_fresnel.h"
#include "core/model/kinds/parameter.h"

namespace nacre {

// Fresnel's equations for a dielectric, from air (Born & Wolf, sec. 1.5.2).
struct DielectricFresnel {
    double ior = 1.5;
    bool operator==(const DielectricFresnel&) const = default;

    static constexpr const char* name = "dielectric";
    static constexpr const char* label = "Dielectric";
    static constexpr const char* explanation =
        "Glass, plastic or lacquer by its index of refraction, by Fresnel's exact equations.";
    static constexpr const char* note = "";
    static constexpr auto parameters() {
        return std::tuple{NumberParameter<DielectricFresnel>{
            .member = &DielectricFresnel::ior,
            .text =
                {"ior", "IOR",
                 "Index of refraction: water 1.33, plastic 1.5, diamond 2.4. A higher index reflects more: "
                 "((n \u2212 1)/(n + 1))\u00b2 straight on, 4 % for 1.5."},
            .bounds = {limits::ior_min, limits::ior_max},
            .slider = {.ends = {1, 2.5}}}};
    }

    static constexpr const char* formula =
        "root = sqrt(max(0, ior^2 - 1 + c^2)); rs = (c - root)/(c + root); rp = (ior^2 c - root)/(ior^2 c + "
        "root); "
        "F = (rs^2 + rp^2)/2: 0 where ior = 1";
    static constexpr FresnelTables tables = FresnelTables::exact;
    ShaderFresnel shader() const { return {glm::dvec3(ior), {}}; }
    DielectricFresnel beneath(double above) const { return {ior / above}; }
    static std::vector<std::pair<const char*, DielectricFresnel>> singular() {
        return {{"ior 1 + 1e-12", {1 + 1e-12}}};
    }

    // Of a colour's mean; 0.66 is what the largest index reflects.
    static DielectricFresnel of_reflectance(const Reflectance& wanted) {
        const glm::dvec3 f0 = wanted(1);
        const double root = std::sqrt(std::clamp((f0.x + f0.y + f0.z) / 3, 0.0, 0.66));
        const double ior = (1 + root) / (1 - root);
        return {std::clamp(std::round(ior * 1e4) / 1e4, limits::ior_min, limits::ior_max)};
    }
};

}  // namespace nacre
