// A polygon in the plane cut into triangles by a sweep.
#pragma once

#include <array>
#include <cstddef>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace nacre {

// Appends the n - 2 triangles of the polygon with these corners of `points`, in about n log n steps whatever
// its shape (Garey, Johnson, Preparata & Tarjan 1978). Corners may coincide, and edges may touch.
// False, with nothing appended, where the polygon crosses itself or turns clockwise. `steps` is raised by the
// edges and corners that were looked at.
bool sweep_polygon(std::span<const glm::dvec2> points, std::span<const std::size_t> corners,
                   std::vector<std::array<std::size_t, 3>>& triangles, std::size_t& steps);

}  // namespace nacre
