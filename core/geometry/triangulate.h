// Polygons in space cut into triangles.
#pragma once

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace nacre {

// The corners of n - 2 triangles that turn as the polygon does: ears cut off one after the other (Meisters
// 1975), seen along the polygon's mean normal (Newell); where that takes long, as with many long thin spikes,
// the rest by a sweep. Corners may coincide, and edges may touch: a hole may be connected by an edge that is
// traversed twice. A polygon that crosses itself is cut into some triangles. `steps` is raised by the steps
// taken, about n log n.
std::vector<std::array<std::size_t, 3>> triangulated(std::span<const glm::dvec3> polygon,
                                                     std::size_t* steps = nullptr);

}  // namespace nacre
