#pragma once

#include <glm/vec3.hpp>
#include <tuple>
#include <utility>
#include <vector>

#include "core/base/limits.h"
#include "core/model/fresnel/shader_fresnel.h"
#include "core/model/kinds/extreme_claims.h"
#include "core/model/kinds/parameter.h"

namespace nacre {

// Fresnel's equations for a conductor of index eta + i k, from air (Born & Wolf, sec. 14.2).
struct ConductorFresnel {
    glm::dvec3 eta{0.2, 0.92, 1.1};
    glm::dvec3 k{3.9, 2.45, 2.14};
    bool operator==(const ConductorFresnel&) const = default;

    static constexpr const char* name = "conductor";
    static constexpr const char* label = "Conductor";
    static constexpr const char* explanation = "A metal by measured eta and k, by Fresnel's exact equations.";
    static constexpr const char* note = "";
    static constexpr auto parameters() {
        return std::tuple{
            TripleParameter<ConductorFresnel>{
                .member = &ConductorFresnel::eta,
                .text = {"eta", "eta",
                         "Real part of the index of refraction eta + i k for red, green and blue. Straight "
                         "on a facet mirrors ((eta \u2212 1)\u00b2 + k\u00b2)/((eta + 1)\u00b2 + k\u00b2)."},
                .bounds = {limits::eta_min, limits::eta_max},
                .slider = {.ends = {0.05, 10}, .format = "%.3g", .logarithmic = true}},
            TripleParameter<ConductorFresnel>{
                .member = &ConductorFresnel::k,
                .text = {"k", "k",
                         "Imaginary part, the absorption, for red, green and blue: the larger, the more "
                         "mirror-like. ((eta \u2212 1)\u00b2 + k\u00b2)/((eta + 1)\u00b2 + k\u00b2) "
                         "straight on."},
                .bounds = {0, limits::k_max},
                .slider = {.ends = {0, 10}, .format = "%.3g"}}};
    }

    static constexpr bool is_metal = true;
    static constexpr const char* formula =
        "u = eta^2 - k^2 - 1 + c^2; m = sqrt(u^2 + (2 eta k)^2); a = sqrt(max(0, (m + u)/2)); b = "
        "sqrt(max(0, (m - u)/2)); "
        "rs = ((a - c)^2 + b^2)/((a + c)^2 + b^2); "
        "rp = rs ((a c - 1 + c^2)^2 + (b c)^2)/((a c + 1 - c^2)^2 + (b c)^2); "
        "F = (rs + rp)/2: each colour; 0 where eta = 1 and k = 0";
    static constexpr FresnelTables tables = FresnelTables::exact;
    ShaderFresnel shader() const { return {eta, k}; }
    ConductorFresnel beneath(double above) const { return {eta / above, k / above}; }
    // Total reflection without loss begins with a kink in F, which no table follows.
    ExtremeClaims extreme_claims() const {
        for (int i = 0; i < 3; ++i)
            if (eta[i] < 1 && k[i] == 0) return {.albedo = 0.15};
        return {};
    }
    static std::vector<std::pair<const char*, ConductorFresnel>> singular() {
        return {{"index 1", {glm::dvec3(1), glm::dvec3(0)}},
                {"eta (0.001, 1, 100), k (100, 0, 1e-6)", {{1e-3, 1, 100}, {100, 0, 1e-6}}}};
    }

    // This reflectance straight on, kept within 0.001 to 0.998, with the edge tint of Gulbrandsen (2014) that
    // comes nearest at 82 degrees.
    static ConductorFresnel of_reflectance(const Reflectance& wanted);
};

}  // namespace nacre
