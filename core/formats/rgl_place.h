// Where facets and directions stand in the tables of a measured material (Dupuy and Jakob 2018).
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <numbers>

namespace nacre {

// Where a node of `count` stands, from 0 to 1.
inline double unit_place(int index, int count) {
    return count > 1 ? static_cast<double>(index) / (count - 1) : 0;
}

// theta from n, phi from the tangent; radians.
inline glm::dvec3 spherical(double theta, double phi) {
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

// At a place of the unit square: x = sqrt(2 theta/pi), y = (phi + pi)/(2 pi).
inline glm::dvec3 rgl_facet(glm::dvec2 place) {
    return spherical(0.5 * std::numbers::pi * place.x * place.x, (2 * place.y - 1) * std::numbers::pi);
}

inline double elevation_of(glm::dvec3 k) { return std::atan2(std::hypot(k.x, k.y), k.z); }

inline double azimuth_of(glm::dvec3 k) { return k.x == 0 && k.y == 0 ? 0 : std::atan2(k.y, k.x); }

// The place of k after its azimuth is turned back by `turned`, radians.
inline glm::dvec2 rgl_place(glm::dvec3 k, double turned = 0) {
    const double turns = (azimuth_of(k) - turned + std::numbers::pi) / (2 * std::numbers::pi);
    return {std::sqrt(elevation_of(k) * 2 / std::numbers::pi), turns - std::floor(turns)};
}

}  // namespace nacre
