#include "core/geometry/cloth.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <random>

namespace nacre {
namespace {

constexpr double gravity = 9.81;
constexpr double drop = 0.01;  // metres above the table at the beginning

// All points weigh the same, so a correction is shared evenly. `softness` is the compliance over the step's
// square and the inverse mass.                                             (Macklin et al. 2016, eq. 18, with
// lambda = 0)
void keep_distance(glm::dvec3& a, glm::dvec3& b, double rest, double softness) {
    const glm::dvec3 between = b - a;
    const double length = glm::length(between);
    if (!(length > 0)) return;
    const glm::dvec3 move = between * ((length - rest) / (length * (2 + softness)));
    a += move;
    b -= move;
}

// Three points in a row resist the curvature |a - 2 b + c|/spacing^2.
void keep_straight(glm::dvec3& a, glm::dvec3& b, glm::dvec3& c, double softness) {
    const glm::dvec3 move = (a - 2.0 * b + c) / (6 + softness);
    a -= move;
    b += 2.0 * move;
    c -= move;
}

// What holds a point to its neighbours.
void solve_at(Cloth& cloth, int column, int row, double shear_softness, double bending_softness) {
    const int n = cloth.side;
    const double diagonal = cloth.spacing * std::numbers::sqrt2;
    glm::dvec3& here = cloth.point(column, row);
    const bool right = column + 1 < n, up = row + 1 < n;
    if (right && up) keep_distance(here, cloth.point(column + 1, row + 1), diagonal, shear_softness);
    if (column > 0 && up) keep_distance(here, cloth.point(column - 1, row + 1), diagonal, shear_softness);
    if (column > 0 && right)
        keep_straight(cloth.point(column - 1, row), here, cloth.point(column + 1, row), bending_softness);
    if (row > 0 && up)
        keep_straight(cloth.point(column, row - 1), here, cloth.point(column, row + 1), bending_softness);
    if (right) keep_distance(here, cloth.point(column + 1, row), cloth.spacing, 0);
    if (up) keep_distance(here, cloth.point(column, row + 1), cloth.spacing, 0);
}

// Once over all points, to and fro: sweeps in one direction alone would push the cloth along.
void solve(Cloth& cloth, bool forth, double shear_softness, double bending_softness) {
    const int n = cloth.side;
    for (int i = 0; i < n * n; ++i) {
        const int at = forth ? i : n * n - 1 - i;
        solve_at(cloth, at % n, at / n, shear_softness, bending_softness);
    }
}

// Threads rub against each other: neighbours share a part of what their velocities differ by.
void rub(Cloth& cloth, double part) {
    const int n = cloth.side;
    const auto share = [&](int a, int b) {
        glm::dvec3& first = cloth.velocities[static_cast<std::size_t>(a)];
        glm::dvec3& second = cloth.velocities[static_cast<std::size_t>(b)];
        const glm::dvec3 given = part * (second - first);
        first += given;
        second -= given;
    };
    for (int i = 0; i < n * n; ++i) {
        if (i % n + 1 < n) share(i, i + 1);
        if (i / n + 1 < n) share(i, i + n);
    }
}

// Out of the table, and held there by Coulomb's friction.
void keep_out(const RoundTable& table, const ClothMaterial& material, glm::dvec3 before, glm::dvec3& now) {
    glm::dvec3 away;
    const double depth = material.thickness - distance_to_table(table, now, away);
    if (depth <= 0) return;
    now += away * depth;
    const glm::dvec3 moved = now - before;
    const glm::dvec3 slid = moved - away * glm::dot(away, moved);
    const double length = glm::length(slid);
    if (length > 0) now -= slid * std::min(1.0, material.friction * depth / length);
}

}  // namespace

double distance_to_table(const RoundTable& table, glm::dvec3 point, glm::dvec3& away) {
    const double radius = std::hypot(point.x, point.z), flat = table.radius - table.rim;
    const double inward = radius > flat ? flat / radius : 1;
    const glm::dvec3 nearest(point.x * inward, -table.rim, point.z * inward);
    const double length = glm::length(point - nearest);
    away = length > 0 ? (point - nearest) / length : glm::dvec3(0, 1, 0);
    return length - table.rim;
}

Cloth flat_cloth(int side, double breadth, double turn, unsigned seed) {
    Cloth cloth{side, breadth / (side - 1), {}, {}};
    const double c = std::cos(turn * std::numbers::pi / 180), s = std::sin(turn * std::numbers::pi / 180);
    std::mt19937 random(seed);
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column) {
            const double x = column * cloth.spacing - breadth / 2, z = breadth / 2 - row * cloth.spacing;
            const double lift = 1e-4 * static_cast<double>(random()) / 4294967296.0;
            cloth.points.emplace_back(c * x + s * z, drop + lift, c * z - s * x);
        }
    cloth.velocities.assign(cloth.points.size(), glm::dvec3(0));
    return cloth;
}

Cloth refined(const Cloth& cloth) {
    const int n = cloth.side, side = 2 * n - 1;
    Cloth fine{side, cloth.spacing / 2, {}, {}};
    fine.points.resize(static_cast<std::size_t>(side) * static_cast<std::size_t>(side));
    fine.velocities = fine.points;
    for (int row = 0; row < n; ++row)
        for (int column = 0; column < n; ++column) {
            const auto from = static_cast<std::size_t>(row * n + column);
            const auto to = static_cast<std::size_t>(2 * row * side + 2 * column);
            fine.points[to] = cloth.points[from];
            fine.velocities[to] = cloth.velocities[from];
        }
    const auto between = [&](std::vector<glm::dvec3>& field, int at, int stride) {
        const auto i = static_cast<std::size_t>(at), d = static_cast<std::size_t>(stride);
        field[i] = 0.5 * (field[i - d] + field[i + d]);
    };
    for (std::vector<glm::dvec3>* field : {&fine.points, &fine.velocities}) {
        for (int row = 0; row < side; row += 2)
            for (int column = 1; column < side; column += 2) between(*field, row * side + column, 1);
        for (int row = 1; row < side; row += 2)
            for (int column = 0; column < side; ++column) between(*field, row * side + column, side);
    }
    return fine;
}

void let_fall(Cloth& cloth, const RoundTable& table, const ClothMaterial& material, double seconds,
              double step) {
    const double area = cloth.spacing * cloth.spacing;
    const double mass = material.density * area;
    const double shear_softness = mass / (material.shear * step * step);
    const double bending_softness = mass * area / (material.bending * step * step);
    const double kept = 1 - material.drag * step;
    std::vector<glm::dvec3> before;
    for (int i = 0; i < static_cast<int>(std::lround(seconds / step)); ++i) {
        before = cloth.points;
        for (std::size_t p = 0; p < cloth.points.size(); ++p) {
            cloth.velocities[p].y -= gravity * step;
            cloth.points[p] += cloth.velocities[p] * step;
        }
        solve(cloth, i % 2 == 0, shear_softness, bending_softness);
        for (std::size_t p = 0; p < cloth.points.size(); ++p) {
            keep_out(table, material, before[p], cloth.points[p]);
            cloth.velocities[p] = (cloth.points[p] - before[p]) * (kept / step);
        }
        rub(cloth, material.rubbing);
    }
}

}  // namespace nacre
