// Polygons in space cut into triangles.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace nacre {

// The corners of n - 2 triangles that turn as the polygon does: ears cut off one after the other (Meisters
// 1975), seen along the polygon's mean normal (Newell). A polygon that crosses itself is cut into some
// triangles.
std::vector<std::array<std::size_t, 3>> triangulated(std::span<const glm::dvec3> polygon);

}  // namespace nacre
