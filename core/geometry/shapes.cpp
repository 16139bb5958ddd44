#include "core/geometry/shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <numbers>

namespace nacre {
namespace {

constexpr float pi = std::numbers::pi_v<float>;

// Of the plate before it is domed: the square of side 2 core, grown by `round` in every direction.
struct TilePoint {
    glm::vec3 position{0};
    glm::vec3 normal{0};
};

// `at` covers the upper half: [-1, 1] is flat, what lies beyond in [-2, 2] bends down to the rim.
TilePoint tile_point(const PlateShape& shape, glm::vec2 at) {
    const glm::vec2 flat = glm::clamp(at, -1.0f, 1.0f);
    const glm::vec2 beyond = at - flat;
    const float turn = std::max(std::abs(beyond.x), std::abs(beyond.y)) * (pi / 2);
    const float length = glm::length(beyond);
    const glm::vec2 outward = length > 0 ? beyond / length : glm::vec2(0);
    const glm::vec3 normal(std::sin(turn) * outward, std::cos(turn));
    return {glm::vec3(shape.core * flat, 0) + shape.round * normal, normal};
}

// x carried along with the shortest turn that brings z to the normal       (Duff 2017, listing 2, for z >= 0)
glm::vec3 carried_x(glm::vec3 n) {
    const float a = 1 / (1 + n.z);
    return {1 - n.x * n.x * a, -n.x * n.y * a, -n.x};
}

// The dome bends z by -dome (x^2 + y^2)/2: directions follow its Jacobian, normals the inverse transpose.
void add_domed(Mesh& mesh, const PlateShape& shape, const TilePoint& tile, glm::vec3 tangent) {
    const glm::vec3 p = tile.position, n = tile.normal;
    const float dx = shape.dome * p.x, dy = shape.dome * p.y;
    const glm::vec3 normal = glm::normalize(n + n.z * glm::vec3(dx, dy, 0));
    const glm::vec3 along = tangent - glm::vec3(0, 0, dx * tangent.x + dy * tangent.y);
    mesh.positions.push_back(p - glm::vec3(0, 0, 0.5f * (dx * p.x + dy * p.y)));
    mesh.normals.push_back(normal);
    mesh.tangents.push_back(glm::normalize(along - normal * glm::dot(normal, along)));
}

// Where the grid's lines cross the tile, in the coordinates of tile_point.
std::vector<float> tile_lines() {
    constexpr int flat = 48, bent = 12;
    std::vector<float> lines;
    for (int i = 0; i < bent; ++i) lines.push_back(-2 + static_cast<float>(i) / bent);
    for (int i = 0; i < flat; ++i) lines.push_back(-1 + 2 * static_cast<float>(i) / flat);
    for (int i = 0; i <= bent; ++i) lines.push_back(1 + static_cast<float>(i) / bent);
    return lines;
}

// The tile's cells, cut toward the nearest corner of the tile: the other diagonal of a corner's last cell
// runs along the rim, and its triangle would lie in the rim's plane.
std::vector<std::uint32_t> tile_triangles(std::uint32_t side) {
    std::vector<std::uint32_t> indices = grid_triangles(side, side);
    const std::uint32_t cells = side - 1;
    for (std::uint32_t row = 0; row < cells; ++row)
        for (std::uint32_t column = 0; column < cells; ++column) {
            if ((2 * row < cells) == (2 * column < cells)) continue;
            const std::uint32_t a = row * side + column, b = a + 1, c = a + side, d = c + 1;
            const std::size_t at = std::size_t{6} * (row * cells + column);
            std::copy_n(std::array{a, b, c, b, d, c}.begin(), 6,
                        indices.begin() + static_cast<std::ptrdiff_t>(at));
        }
    return indices;
}

}  // namespace

Mesh torus(float tube) {
    constexpr std::uint32_t around = 192, across = 96;
    Mesh mesh;
    for (std::uint32_t row = 0; row <= around; ++row)
        for (std::uint32_t column = 0; column <= across; ++column) {
            // The last line coincides with the first.
            const float u = 2 * pi * static_cast<float>(row % around) / around;
            const float v = 2 * pi * static_cast<float>(column % across) / across;
            const glm::vec3 outward(std::sin(u), 0, std::cos(u));
            const glm::vec3 normal = std::cos(v) * outward + glm::vec3(0, std::sin(v), 0);
            mesh.positions.push_back((1 - tube) * outward + tube * normal);
            mesh.normals.push_back(normal);
            mesh.tangents.emplace_back(std::cos(u), 0.0f, -std::sin(u));
        }
    mesh.indices = grid_triangles(across + 1, around + 1);
    // Along a row runs north, along a column east: their cross product points inward.
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
        std::swap(mesh.indices[i + 1], mesh.indices[i + 2]);
    return mesh;
}

Mesh plate(const PlateShape& shape) {
    const std::vector<float> lines = tile_lines();
    const auto side = static_cast<std::uint32_t>(lines.size());
    Mesh mesh;
    for (const float half : {1.0f, -1.0f})
        for (const float y : lines)
            for (const float x : lines) {
                TilePoint tile = tile_point(shape, {x, y});
                glm::vec3 tangent = carried_x(tile.normal);
                tile.position.z *= half;
                tile.normal.z *= half;
                tangent.z *= half;
                add_domed(mesh, shape, tile, tangent);
            }
    mesh.indices = tile_triangles(side);
    const std::vector<std::uint32_t> front = mesh.indices;
    for (std::size_t i = 0; i < front.size(); i += 3)
        for (const std::size_t corner : {std::size_t{0}, std::size_t{2}, std::size_t{1}})
            mesh.indices.push_back(front[i + corner] + side * side);
    fit(mesh);
    return mesh;
}

}  // namespace nacre
