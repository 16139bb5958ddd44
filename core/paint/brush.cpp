#include "core/paint/brush.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace nacre {

double brush_falloff(const Brush& brush, double distance) {
    if (distance >= 1) return 0;
    if (distance <= brush.hardness) return 1;
    const double t = (1 - distance) / (1 - brush.hardness);
    return t * t * (3 - 2 * t);
}

Touch between(const Touch& a, const Touch& b, double part) {
    return {std::lerp(a.pressure, b.pressure, part), std::lerp(a.slowness, b.slowness, part)};
}

Brush touched(const Brush& brush, const Touch& touch) {
    constexpr double narrowest = 0.1;
    const auto part = [&](Follows what) {
        switch (what) {
            case Follows::pressure:
                return touch.pressure;
            case Follows::speed:
                return touch.slowness;
            case Follows::nothing:
                break;
        }
        return 1.0;
    };
    Brush now = brush;
    now.radius = std::max(brush.radius * std::lerp(narrowest, 1.0, part(brush.radius_follows)),
                          std::min(brush.radius, brush_radius_min));
    now.flow = brush.flow * part(brush.flow_follows);
    return now;
}

double painted(const Brush& brush, double value, double amount) {
    switch (brush.blend) {
        case Blend::replace:
            break;
        case Blend::add:
            return std::min(value + amount * brush.value, 1.0);
        case Blend::multiply:
            return value * (1 + amount * (brush.value - 1));
        case Blend::maximum:
            return std::max(value, amount * brush.value);
    }
    return value + amount * (brush.value - value);
}

double angle_between(dvec3 a, dvec3 b) { return 2 * std::asin(std::min(0.5 * glm::length(a - b), 1.0)); }

glm::dmat3 shortest_rotation(dvec3 a, dvec3 b) {
    // Rodrigues, with v = a x b and c = a.b: I + [v] + [v]^2/(1 + c).
    const dvec3 v = glm::cross(a, b);
    const double k = 1 / (1 + glm::dot(a, b));
    const glm::dmat3 cross{{0, v.z, -v.y}, {-v.z, 0, v.x}, {v.y, -v.x, 0}};
    return glm::dmat3(1) + cross + k * (cross * cross);
}

std::vector<glm::dmat3> symmetry_images(const BrushSymmetry& symmetry) {
    const auto scaling = [](double x, double y) { return glm::dmat3{{x, 0, 0}, {0, y, 0}, {0, 0, 1}}; };
    switch (symmetry.kind) {
        case SymmetryKind::mirror_x:
            return {scaling(1, 1), scaling(-1, 1)};
        case SymmetryKind::mirror_y:
            return {scaling(1, 1), scaling(1, -1)};
        case SymmetryKind::mirror_both:
            return {scaling(1, 1), scaling(-1, 1), scaling(1, -1), scaling(-1, -1)};
        case SymmetryKind::turns: {
            std::vector<glm::dmat3> images;
            const int count = std::clamp(symmetry.turns, turns_min, turns_max);
            for (int i = 0; i < count; ++i) {
                double c = std::cos(2 * std::numbers::pi * i / count);
                double s = std::sin(2 * std::numbers::pi * i / count);
                if (4 * i % count == 0) {  // quarter turns stay exact
                    c = std::round(c);
                    s = std::round(s);
                }
                images.push_back({{c, s, 0}, {-s, c, 0}, {0, 0, 1}});
            }
            return images;
        }
        case SymmetryKind::none:
        case SymmetryKind::ring:
            break;
    }
    return {glm::dmat3(1)};
}

}  // namespace nacre
