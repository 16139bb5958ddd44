#include "core/model/fresnel/curve.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <numbers>

#include "core/model/spectral/fresnel_curve.h"

namespace nacre {
namespace {

double cosine_at(double theta) { return theta == 90 ? 0 : std::cos(theta * (std::numbers::pi / 180)); }

}  // namespace

// Drawn as it is to be, whatever it lies in.
Reflectance CurveFresnel::reflectance(double) const {
    return [points = points](double cosine) {
        // The first point that lies at a smaller cosine.
        const auto after = std::find_if(points.begin(), points.end(),
                                        [&](const ColourPoint& p) { return cosine_at(p.theta) < cosine; });
        if (after == points.begin()) return points.front().colour;
        if (after == points.end()) return points.back().colour;
        const ColourPoint &a = *std::prev(after), &b = *after;
        const double begin = cosine_at(a.theta), end = cosine_at(b.theta);
        return glm::mix(a.colour, b.colour, (begin - cosine) / (begin - end));
    };
}

ShaderFresnel CurveFresnel::shader(double) const {
    static CurveMemory<CurveFresnel> memory;
    return {.curve = memory.curve_of(*this, 1)};
}

// The table of R holds the difference to F at k.n, and a step of F with that.
ExtremeClaims CurveFresnel::extreme_claims() const {
    if (shader().curve->error > 0.01) return {.albedo = 0.15};
    return {};
}

CurveFresnel CurveFresnel::of_reflectance(const Reflectance& wanted) {
    CurveFresnel curve;
    curve.points.clear();
    for (const double theta : {0.0, 35.0, 50.0, 60.0, 70.0, 76.0, 80.0, 84.0, 87.0, 90.0})
        curve.points.push_back({theta, glm::clamp(wanted(cosine_at(theta)), 0.0, 1.0)});
    return curve;
}

}  // namespace nacre
