#include "core/geometry/mesh.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace nacre {

void fit(std::vector<glm::dvec3>& points) {
    glm::dvec3 low = points.at(0), high = low;
    for (const glm::dvec3& p : points) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    const glm::dvec3 middle = 0.5 * (low + high), half = 0.5 * (high - low);
    // Of a size about 1, so that no square is too large or too small for a number; powers of 2 round nothing.
    const int exponent = -std::ilogb(std::max({half.x, half.y, half.z}));
    double farthest = 0;
    for (glm::dvec3& p : points) {
        for (int i = 0; i < 3; ++i) p[i] = std::scalbn(p[i] - middle[i], exponent);
        farthest = std::max(farthest, glm::length(p));
    }
    for (glm::dvec3& p : points) p /= farthest;
}

void fit(Mesh& mesh) {
    std::vector<glm::dvec3> points(mesh.positions.begin(), mesh.positions.end());
    fit(points);
    mesh.positions.assign(points.begin(), points.end());
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
