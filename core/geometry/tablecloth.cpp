#include "core/geometry/tablecloth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <span>

namespace nacre {

// From tablecloth.obj, row by row; the build makes it.
std::span<const std::array<double, 3>> tablecloth_points();

namespace {

constexpr int pieces = 2;  // of the mesh between two points of the cloth

// A curve's point and its derivative.
struct CurvePoint {
    glm::dvec3 value{0}, slope{0};
};

// The uniform cubic B-spline at t in [0, 1] between b and c.
CurvePoint spline(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c, glm::dvec3 d, double t) {
    const double u = 1 - t;
    return {
        (u * u * u * a + (4 - 3 * t * t * (2 - t)) * b + (4 - 3 * u * u * (2 - u)) * c + t * t * t * d) / 6.0,
        (-u * u * a + (3 * t - 4) * t * b + (4 - 3 * u) * u * c + t * t * d) / 2.0};
}

// The points of the cloth, and beyond each edge the one that makes the spline end on the edge.
glm::dvec3 control(const Cloth& cloth, int column, int row) {
    const int last = cloth.side - 1;
    if (column < 0) return 2.0 * control(cloth, 0, row) - control(cloth, 1, row);
    if (column > last) return 2.0 * control(cloth, last, row) - control(cloth, last - 1, row);
    if (row < 0) return 2.0 * cloth.point(column, 0) - cloth.point(column, 1);
    if (row > last) return 2.0 * cloth.point(column, last) - cloth.point(column, last - 1);
    return cloth.point(column, row);
}

void add_point(Mesh& mesh, const Cloth& cloth, int i, int j) {
    const int column = std::min(i / pieces, cloth.side - 2), row = std::min(j / pieces, cloth.side - 2);
    const double s = static_cast<double>(i - column * pieces) / pieces;
    const double t = static_cast<double>(j - row * pieces) / pieces;
    std::array<CurvePoint, 4> lines;
    for (int k = 0; k < 4; ++k) {
        const int r = row - 1 + k;
        lines[static_cast<std::size_t>(k)] =
            spline(control(cloth, column - 1, r), control(cloth, column, r), control(cloth, column + 1, r),
                   control(cloth, column + 2, r), s);
    }
    const CurvePoint weft = spline(lines[0].value, lines[1].value, lines[2].value, lines[3].value, t);
    const glm::dvec3 warp = spline(lines[0].slope, lines[1].slope, lines[2].slope, lines[3].slope, t).value;
    const glm::dvec3 tangent = glm::normalize(warp);
    mesh.positions.emplace_back(weft.value);
    mesh.tangents.emplace_back(tangent);
    mesh.normals.emplace_back(glm::normalize(glm::cross(tangent, weft.slope)));
}

}  // namespace

Cloth draped_cloth() {
    const auto grid = tablecloth_points();
    Cloth cloth{static_cast<int>(std::lround(std::sqrt(grid.size()))), {}};
    for (const auto& [x, y, z] : grid) cloth.points.emplace_back(x, y, z);
    return cloth;
}

Mesh cloth_mesh(const Cloth& cloth) {
    const int side = (cloth.side - 1) * pieces + 1;
    Mesh mesh;
    for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i) add_point(mesh, cloth, i, j);
    mesh.indices = grid_triangles(static_cast<std::uint32_t>(side), static_cast<std::uint32_t>(side));
    fit(mesh);
    return mesh;
}

}  // namespace nacre
