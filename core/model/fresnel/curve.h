#pragma once

#include <tuple>
#include <utility>
#include <vector>

#include "core/base/limits.h"
#include "core/model/fresnel/shader_fresnel.h"
#include "core/model/kinds/extreme_claims.h"
#include "core/model/kinds/parameter.h"

namespace nacre {

// F drawn by hand.
struct CurveFresnel {
    std::vector<ColourPoint> points = {{0, {0.9, 0.6, 0.25}}, {70, {0.9, 0.7, 0.5}}, {90, glm::dvec3(1)}};
    bool operator==(const CurveFresnel&) const = default;

    static constexpr const char* name = "curve";
    static constexpr const char* label = "Drawn";
    static constexpr const char* explanation =
        "Any colour at any angle, by hand: points with straight lines over the cosine between them.\n"
        "F = the curve at k\u00b7h";
    static constexpr const char* note = "";
    static constexpr int file_version = 2;
    static constexpr auto parameters() {
        return std::tuple{ColourCurveParameter<CurveFresnel>{
            .member = &CurveFresnel::points,
            .text = {"points", "Points",
                     "Colours at angles from the facet's normal, 0 straight on and 90 grazing; straight "
                     "lines over the "
                     "cosine of the angle, and beyond the ends the colours there."},
            .theta_bounds = {0, 90},
            .value_bounds = {0, 1},
            .points_max = limits::fresnel_points_max}};
    }

    static constexpr const char* formula = curve_formula;
    static constexpr FresnelTables tables = FresnelTables::exact;
    static constexpr bool is_curve = true;
    ShaderFresnel shader(double above = 1) const;
    static std::vector<std::pair<const char*, CurveFresnel>> singular() {
        return {{"a step at 45 degrees", {{{45, glm::dvec3(1)}, {45.01, glm::dvec3(0)}}}}};
    }

    ExtremeClaims extreme_claims() const;

    // As drawn.
    Reflectance reflectance(double above = 1) const;
    static CurveFresnel of_reflectance(const Reflectance& wanted);
};

}  // namespace nacre
