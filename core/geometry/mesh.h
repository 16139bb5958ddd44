// Triangle meshes, independent of how they are drawn.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace nacre {

struct Mesh {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;   // unit
    std::vector<glm::vec3> tangents;  // unit, across the normal; 0 where the surface prefers no direction
    std::vector<std::uint32_t>
        indices;  // three a triangle, counterclockwise as seen from where the normals point

    bool operator==(const Mesh&) const = default;
};

// Moves the middle of the bounding box to the origin and scales so that the farthest point is at distance 1.
// The points have an extent.
void fit(std::vector<glm::dvec3>& points);
void fit(Mesh& mesh);

// The triangles of a grid of columns x rows vertices, row after row, facing toward (along a row) x (along a
// column).
std::vector<std::uint32_t> grid_triangles(std::uint32_t columns, std::uint32_t rows);

}  // namespace nacre
