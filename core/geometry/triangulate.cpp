#include "core/geometry/triangulate.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <numeric>

namespace nacre {
namespace {

double turn(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// The polygon seen from where it turns counterclockwise.
std::vector<glm::dvec2> flattened(std::span<const glm::dvec3> polygon) {
    glm::dvec3 normal{0};
    for (std::size_t i = 0; i < polygon.size(); ++i)
        normal += glm::cross(polygon[i] - polygon[0], polygon[(i + 1) % polygon.size()] - polygon[0]);
    const glm::dvec3 size = glm::abs(normal);
    const glm::dvec3 aside = size.x <= size.y && size.x <= size.z ? glm::dvec3(1, 0, 0)
                             : size.y <= size.z                   ? glm::dvec3(0, 1, 0)
                                                                  : glm::dvec3(0, 0, 1);
    const glm::dvec3 x = glm::cross(aside, normal), y = glm::cross(normal, x);
    std::vector<glm::dvec2> flat;
    const double sx = glm::length(x), sy = glm::length(y);
    for (const glm::dvec3& p : polygon)
        flat.emplace_back(sx > 0 ? glm::dot(p - polygon[0], x / sx) : 0,
                          sy > 0 ? glm::dot(p - polygon[0], y / sy) : 0);
    return flat;
}

bool is_ear(const std::vector<glm::dvec2>& flat, const std::vector<std::size_t>& left, std::size_t at) {
    const std::size_t n = left.size(), before = (at + n - 1) % n, after = (at + 1) % n;
    const glm::dvec2 a = flat[left[before]], b = flat[left[at]], c = flat[left[after]];
    if (!(turn(a, b, c) > 0)) return false;
    for (std::size_t i = 0; i < n; ++i) {
        if (i == at || i == before || i == after) continue;
        const glm::dvec2 p = flat[left[i]];
        if (turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0) return false;
    }
    return true;
}

}  // namespace

std::vector<std::array<std::size_t, 3>> triangulated(std::span<const glm::dvec3> polygon) {
    if (polygon.size() < 3) return {};
    const std::vector<glm::dvec2> flat = flattened(polygon);
    std::vector<std::size_t> left(polygon.size());
    std::iota(left.begin(), left.end(), std::size_t{0});
    std::vector<std::array<std::size_t, 3>> triangles;
    while (left.size() > 3) {
        std::size_t ear = 1;  // of what crosses itself or has no area, any corner is cut off
        for (std::size_t i = 1; i <= left.size(); ++i)
            if (is_ear(flat, left, i % left.size())) {
                ear = i % left.size();
                break;
            }
        const std::size_t n = left.size();
        triangles.push_back({left[(ear + n - 1) % n], left[ear], left[(ear + 1) % n]});
        left.erase(left.begin() + static_cast<std::ptrdiff_t>(ear));
    }
    triangles.push_back({left[0], left[1], left[2]});
    return triangles;
}

}  // namespace nacre
