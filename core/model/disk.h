// The equal-area disk on which a distribution is painted and shown: the sphere of facet normals seen from
// above n (Lambert's azimuthal projection, 1772), scaled so that the horizon has radius 1. The nadir is the
// circle of radius sqrt(2). Areas on the disk are solid angles over 2.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace nacre {

// The unit direction at a point no farther than sqrt(2) from the middle.
inline glm::dvec3 disk_direction(glm::dvec2 at) {
    const double r2 = glm::dot(at, at);
    const double scale = std::sqrt(2 - r2);
    return {at.x * scale, at.y * scale, 1 - r2};
}

// Its inverse; the nadir, which is a whole circle, comes out on the x axis.
inline glm::dvec2 disk_point(glm::dvec3 h) {
    const double sine = std::hypot(h.x, h.y);
    const double r = std::sqrt(std::max(1 - h.z, 0.0));
    if (sine == 0) return {h.z < 0 ? r : 0, 0};
    return {h.x / sine * r, h.y / sine * r};
}

}  // namespace nacre
