#pragma once

#include <algorithm>
#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <tuple>
#include <utility>
#include <vector>

#include "core/model/fresnel/shader_fresnel.h"
#include "core/model/kinds/parameter.h"

namespace nacre {

// Schlick's curve less a dip c (1 - c)^6, which is deepest at c = 1/7, by what makes it f82 times as high
// there (Kutz, Hasan and Edmondson 2021, after Lazanyi and Szirmay-Kalos 2005).
struct F82Fresnel {
    glm::dvec3 f0{0.95, 0.7, 0.3};
    glm::dvec3 f82{0.95, 0.9, 0.85};
    bool operator==(const F82Fresnel&) const = default;

    static constexpr const char* name = "f82";
    static constexpr const char* label = "F82";
    static constexpr const char* explanation =
        "Schlick's with a second colour just before grazing, as metals have it: F82 multiplies f0's curve at "
        "82 "
        "degrees.\n"
        "F = max(0, Schlick \u2212 d c (1 \u2212 c)\u2076), c = k\u00b7h";
    static constexpr const char* note = "";
    static constexpr int file_version = 2;
    static constexpr auto parameters() {
        return std::tuple{
            ColourParameter<F82Fresnel>{
                .member = &F82Fresnel::f0,
                .text =
                    {"f0", "f0",
                     "Reflected colour when looking straight at a facet. Linear values; the swatch picks as "
                     "displayed."},
                .bounds = {0, 1}},
            ColourParameter<F82Fresnel>{.member = &F82Fresnel::f82,
                                        .text = {"f82", "F82",
                                                 "Colour near the edge: what is left of Schlick's curve at "
                                                 "82 degrees. White is Schlick's curve "
                                                 "itself; most metals are a little darker there."},
                                        .bounds = {0, 1}}};
    }

    // (1 - c)^5 and c (1 - c)^6 at c = 1/7, where the dip is deepest.
    static constexpr double cosine82 = 1.0 / 7;
    static constexpr double weight82 = 7776.0 / 16807;
    static constexpr double dip82 = 46656.0 / 823543;

    static constexpr bool is_metal = true;
    static constexpr const char* formula =
        "d = (f0 + (1 - f0) (6/7)^5) (1 - f82) 7 (7/6)^6; F = max(0, f0 + (1 - f0) (1 - c)^5 - d c (1 - "
        "c)^6)";
    static constexpr FresnelTables tables = FresnelTables::exact;
    ShaderFresnel shader() const { return {f0, (f0 + (1.0 - f0) * weight82) * (1.0 - f82) / dip82}; }
    F82Fresnel beneath(double above) const { return {reflectance_beneath(f0, above), f82}; }
    // A dark f0 and a dark edge: F is 0 over a range of angles, with a kink at either end.
    static std::vector<std::pair<const char*, F82Fresnel>> singular() {
        return {{"f0 0.02, F82 0", {glm::dvec3(0.02), glm::dvec3(0)}}};
    }

    static F82Fresnel of_reflectance(const Reflectance& wanted) {
        F82Fresnel model{glm::clamp(wanted(1), 0.0, 1.0), {}};
        const glm::dvec3 edge = wanted(cosine82);
        for (int i = 0; i < 3; ++i)
            model.f82[i] = std::clamp(edge[i] / (model.f0[i] + (1 - model.f0[i]) * weight82), 0.0, 1.0);
        return model;
    }
};

}  // namespace nacre
