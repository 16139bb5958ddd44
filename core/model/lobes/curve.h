#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "core/model/kinds/kind.h"
#include "core/model/lobes/shader_lobe.h"
#include "core/model/lobes/widths.h"

namespace nacre {

class LobeModel;

// p(theta) through (theta in degrees, value) points with straight lines between them; 0 outside.
struct CurveLobe {
    std::vector<std::pair<double, double>> points = {{0, 1}, {20, 0}};
    bool operator==(const CurveLobe&) const = default;

    static constexpr const char* name = "curve";
    static constexpr const char* label = "Curve";
    static constexpr const char* explanation =
        "p as a curve over the angle from the normal: a core with its haze, halos, a flat top.\n"
        "p ~ the curve at \u03b8, straight lines between its points";
    static constexpr auto parameters() {
        return std::tuple{CurveParameter<CurveLobe>{.member = &CurveLobe::points,
                                                    .text = {"points", "Curve", explanation},
                                                    .theta_bounds = {0, 180},
                                                    .value_bounds = {0, limits::weight_max},
                                                    .points_max = limits::curve_points_max}};
    }

    static constexpr WidthMembers<CurveLobe> width_members{};

    // Eq. 34 along one azimuth, at even angles out to where it has faded.
    static CurveLobe of_widths(glm::dvec2 widths) {
        constexpr int count = 7;
        constexpr double degree = std::numbers::pi / 180;
        const double width = std::clamp(std::min(finite_width(widths.x), finite_width(widths.y)), 1e-2, 2.0);
        const double end = std::min(90.0, std::atan(2.2 * width) / degree);
        CurveLobe curve;
        curve.points.clear();
        for (int i = 0; i < count; ++i) {
            const double theta = std::round(end * i / (count - 1) * 100) / 100;
            const double slope = std::tan(theta * degree) / width;
            const double value = i == count - 1 ? 0 : std::exp(-slope * slope);
            curve.points.emplace_back(theta, std::round(value * 1000) / 1000);
        }
        return curve;
    }

    static std::vector<std::pair<const char*, CurveLobe>> singular() {
        return {{"a ring 0.002 degrees wide", {{{20, 0}, {20.001, 1}, {20.002, 0}}}},
                {"a step at the horizon", {{{0, 1}, {90, 1}}}}};
    }

    double period() const { return 0; }
    bool reaches_below() const { return !points.empty() && points.back().first > 90; }
    const char* table_kind() const { return name; }
    const char* formula() const {
        return "curve(acos(z)), also where z <= 0: straight lines through the points of `curve`, 0 outside "
               "them";
    }
    ShaderLobe shader() const;
    std::shared_ptr<const LobeModel> model() const;
};

}  // namespace nacre
