// Directions by their angles.
#pragma once

#include <cmath>
#include <glm/vec3.hpp>
#include <numbers>

namespace nacre {

// Angles from n and from +x toward +y, degrees.
inline glm::dvec3 polar_direction(double theta, double phi) {
    constexpr double degree = std::numbers::pi / 180;
    const double sine = std::sin(theta * degree);
    return {sine * std::cos(phi * degree), sine * std::sin(phi * degree), std::cos(theta * degree)};
}

// [0, 180]
inline double polar_angle(glm::dvec3 h) {
    return std::atan2(std::hypot(h.x, h.y), h.z) * (180 / std::numbers::pi);
}

// (-180, 180]; 0 for n itself, which has none.
inline double azimuth(glm::dvec3 h) {
    return h.x == 0 && h.y == 0 ? 0 : std::atan2(h.y, h.x) * (180 / std::numbers::pi);
}

}  // namespace nacre
