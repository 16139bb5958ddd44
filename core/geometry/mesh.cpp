#include "core/geometry/mesh.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace nacre {

void fit(Mesh& mesh) {
    glm::vec3 low = mesh.positions.at(0), high = low;
    for (const glm::vec3& p : mesh.positions) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    // In double: the coordinates of a file may be as large as float has them.
    const glm::dvec3 middle = 0.5 * (glm::dvec3(low) + glm::dvec3(high));
    double farthest = 0;
    for (const glm::vec3& p : mesh.positions)
        farthest = std::max(farthest, glm::length(glm::dvec3(p) - middle));
    for (glm::vec3& p : mesh.positions) p = glm::vec3((glm::dvec3(p) - middle) / farthest);
}

std::vector<std::uint32_t> grid_triangles(std::uint32_t columns, std::uint32_t rows) {
    std::vector<std::uint32_t> indices;
    indices.reserve(std::size_t{6} * (columns - 1) * (rows - 1));
    for (std::uint32_t row = 0; row + 1 < rows; ++row)
        for (std::uint32_t column = 0; column + 1 < columns; ++column) {
            const std::uint32_t a = row * columns + column, b = a + 1, c = a + columns, d = c + 1;
            indices.insert(indices.end(), {a, b, d, a, d, c});
        }
    return indices;
}

}  // namespace nacre
