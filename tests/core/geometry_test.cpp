// The preview's objects: closed forms, orthonormal frames, and what a cloth must not do.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>
#include <random>
#include <vector>

#include "core/geometry/normal_sums.h"
#include "core/geometry/polygons.h"
#include "core/geometry/shapes.h"
#include "core/geometry/tablecloth.h"
#include "core/geometry/triangulate.h"

using namespace nacre;

namespace {

// Where the corners' frames are no frames, or a triangle faces away from its normals.
int wrong_frames(const Mesh& mesh) {
    int wrong = 0;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const glm::vec3 n = mesh.normals[i], t = mesh.tangents[i];
        if (!(std::abs(glm::length(n) - 1) < 1e-5f)) ++wrong;
        if (t != glm::vec3(0) && !(std::abs(glm::length(t) - 1) < 1e-5f && std::abs(glm::dot(n, t)) < 1e-5f))
            ++wrong;
    }
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const auto a = mesh.indices[i], b = mesh.indices[i + 1], c = mesh.indices[i + 2];
        const glm::vec3 across =
            glm::cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]);
        if (glm::dot(across, mesh.normals[a] + mesh.normals[b] + mesh.normals[c]) < 0) ++wrong;
    }
    return wrong;
}

bool without_tangents(const Mesh& mesh) {
    return std::any_of(mesh.tangents.begin(), mesh.tangents.end(),
                       [](glm::vec3 t) { return t == glm::vec3(0); });
}

double farthest(const Mesh& mesh) {
    double r = 0;
    for (const glm::vec3& p : mesh.positions) r = std::max(r, static_cast<double>(glm::length(p)));
    return r;
}

// Six times the volume that a closed mesh encloses.
double volume(const Mesh& mesh) {
    double sum = 0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
        sum += glm::dot(glm::dvec3(mesh.positions[mesh.indices[i]]),
                        glm::cross(glm::dvec3(mesh.positions[mesh.indices[i + 1]]),
                                   glm::dvec3(mesh.positions[mesh.indices[i + 2]])));
    return sum / 6;
}

// How far threads are from their rest length, of it.
double worst_stretch(const Cloth& cloth, double spacing) {
    double worst = 0;
    for (int row = 0; row < cloth.side; ++row)
        for (int column = 0; column < cloth.side; ++column)
            for (const bool weft : {false, true}) {
                if ((weft ? row : column) + 1 == cloth.side) continue;
                const glm::dvec3 next = weft ? cloth.point(column, row + 1) : cloth.point(column + 1, row);
                worst = std::max(worst, std::abs(glm::length(next - cloth.point(column, row)) / spacing - 1));
            }
    return worst;
}

// Whether two points meet that are far from each other along the cloth: folds that run through each other.
bool meets_itself(const Cloth& cloth, double spacing) {
    const double reach = 0.6 * spacing;
    std::map<std::array<long, 3>, std::vector<int>> cells;
    const auto cell = [&](glm::dvec3 p) {
        return std::array{std::lround(p.x / reach), std::lround(p.y / reach), std::lround(p.z / reach)};
    };
    const auto far = [&](int a, int b) {
        return std::max(std::abs(a % cloth.side - b % cloth.side),
                        std::abs(a / cloth.side - b / cloth.side)) > 6;
    };
    for (int i = 0; i < cloth.side * cloth.side; ++i) {
        const glm::dvec3 p = cloth.points[static_cast<std::size_t>(i)];
        const auto [x, y, z] = cell(p);
        for (int k = 0; k < 27; ++k)
            for (const int j : cells[{x + k % 3 - 1, y + k / 3 % 3 - 1, z + k / 9 - 1}])
                if (far(i, j) && glm::length(p - cloth.points[static_cast<std::size_t>(j)]) < reach)
                    return true;
        cells[{x, y, z}].push_back(i);
    }
    return false;
}

}  // namespace

TEST_CASE("geometry: every vertex of every shape has an orthonormal frame on its outer side") {
    for (const Mesh& mesh :
         {torus(), torus(0.2f), plate(), plate({0.4f, 0.3f, 0.0f}), cloth_mesh(draped_cloth())}) {
        CHECK(wrong_frames(mesh) == 0);
        CHECK(!without_tangents(mesh));
        CHECK(farthest(mesh) == doctest::Approx(1).epsilon(1e-5));
    }
}

TEST_CASE("geometry: the torus is where its equation says, with its gradient and its volume") {
    const double tube = 0.36, ring = 1 - tube;
    const Mesh mesh = torus(0.36f);
    double off = 0, tilt = 0, along = 0;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const glm::dvec3 p(mesh.positions[i]), n(mesh.normals[i]);
        const double r = std::hypot(p.x, p.z);
        off = std::max(off, std::abs((r - ring) * (r - ring) + p.y * p.y - tube * tube));
        const glm::dvec3 gradient((r - ring) * p.x / r, p.y, (r - ring) * p.z / r);
        tilt = std::max(tilt, glm::length(n - gradient / tube));
        // Around the axis: no part of the tangent goes outward or up.
        along =
            std::max(along, std::abs(glm::dot(glm::dvec3(mesh.tangents[i]), glm::dvec3(p.x, 0, p.z) / r)));
    }
    CHECK(off < 1e-6);
    CHECK(tilt < 1e-6);
    CHECK(along < 1e-6);
    const double pi = 3.14159265358979;
    CHECK(volume(mesh) == doctest::Approx(2 * pi * pi * ring * tube * tube).epsilon(2e-3));
}

TEST_CASE("geometry: the plate's volume is that of a rounded square, which a dome does not change") {
    const PlateShape shape{0.5f, 0.2f, 0.0f};
    const double pi = 3.14159265358979, a = 1.0, r = 0.2;  // Steiner's formula for a square of side a
    const double expected = 2 * r * a * a + pi * r * r * 2 * a + 4.0 / 3 * pi * r * r * r;
    const double scale = std::sqrt(2 * 0.5 * 0.5) + 0.2;  // the farthest point, at distance 1 after fit()
    CHECK(volume(plate(shape)) * scale * scale * scale == doctest::Approx(expected).epsilon(5e-3));
    const Mesh domed = plate({0.5f, 0.2f, 0.6f});
    // The normals of the middle follow the paraboloid z = -0.6 (x^2 + y^2)/2: the tangents' slope is -0.6 x.
    int seen = 0;
    double worst = 0;
    for (std::size_t i = 0; i < domed.positions.size(); ++i) {
        const glm::vec3 n = domed.normals[i], t = domed.tangents[i];
        if (n.z < 0.95f) continue;
        worst = std::max(worst, static_cast<double>(std::abs(t.z / t.x + n.x / n.z)));
        ++seen;
    }
    CHECK(seen > 500);
    CHECK(worst < 2e-2);
}

TEST_CASE("cloth: it hangs, does not stretch, and stays out of the table and of itself") {
    const Cloth cloth = draped_cloth();
    REQUIRE(cloth.side == 129);
    REQUIRE(cloth.points.size() == 129 * 129);
    const double spacing = 1.75 / 128;
    CHECK(worst_stretch(cloth, spacing) < 0.05);
    CHECK(!meets_itself(cloth, spacing));
    // The table is 6 cm thick and the cloth 8 mm away from it.
    int in_table = 0;
    double lowest = 0;
    for (const glm::dvec3& p : cloth.points) {
        in_table += std::hypot(p.x, p.z) < 0.39 && p.y > -0.066 && p.y < 0.006;
        lowest = std::min(lowest, p.y);
    }
    CHECK(in_table == 0);
    CHECK(lowest < -0.5);
}

TEST_CASE("cloth: a flat one becomes a flat mesh whose tangents run along the warp") {
    Cloth flat{9, {}};
    for (int i = 0; i < 81; ++i) flat.points.emplace_back(0.125 * (i % 9), 0, -0.125 * (i / 9));
    const Mesh mesh = cloth_mesh(flat);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        CHECK(mesh.normals[i].y > 0.999f);
        CHECK(mesh.tangents[i].x > 0.999f);
    }
}

TEST_CASE("geometry: a polygon is cut into triangles of its own area") {
    // An L, leaning in space.
    const std::vector<glm::dvec2> flat{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 2}, {0, 2}};
    std::vector<glm::dvec3> polygon;
    for (const glm::dvec2& p : flat) polygon.emplace_back(p.x, 0.6 * p.y, 0.8 * p.y);
    double area = 0;
    for (const auto& t : triangulated(polygon)) {
        const glm::dvec3 cross = glm::cross(polygon[t[1]] - polygon[t[0]], polygon[t[2]] - polygon[t[0]]);
        CHECK(glm::dot(cross, glm::dvec3(0, -0.8, 0.6)) > 0);
        area += glm::length(cross) / 2;
    }
    CHECK(area == doctest::Approx(4));
    CHECK(triangulated(polygon).size() == 4);
    CHECK(triangulated(std::vector<glm::dvec3>(7, glm::dvec3(1))).size() == 5);  // without area
}

TEST_CASE("geometry: made normals are smooth below the crease angle and sharp above it") {
    // Two squares that meet at an angle along x = 0.
    const auto roof = [](double slope) {
        Triangles t;
        const double z = -slope;
        t.positions = {{-1, 0, z}, {0, 0, 0}, {0, 1, 0}, {-1, 1, z}, {1, 0, z}, {1, 1, z}};
        const auto corner = [](int p) { return Triangles::Corner{p, absent, absent}; };
        for (const auto& f : {std::array{0, 1, 2}, {0, 2, 3}, {1, 4, 5}, {1, 5, 2}})
            t.faces.push_back({corner(f[0]), corner(f[1]), corner(f[2])});
        return mesh_of(t);
    };
    const Mesh smooth = roof(0.3), sharp = roof(2);
    CHECK(smooth.positions.size() == 6);
    CHECK(sharp.positions.size() == 8);  // those of the ridge stand twice
    for (std::size_t i = 0; i < smooth.positions.size(); ++i)
        if (smooth.positions[i].x == 0) CHECK(smooth.normals[i].z == doctest::Approx(1));
    CHECK(wrong_frames(smooth) == 0);
    CHECK(wrong_frames(sharp) == 0);
}

TEST_CASE("geometry: sums of normals within an angle are those of all pairs, in steps that hardly grow") {
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    std::vector<WeightedNormal> normals;
    for (int i = 0; i < 40000; ++i)
        normals.push_back({glm::normalize(glm::dvec3(normal(random), normal(random), normal(random))),
                           1 + 0.5 * std::sin(i)});
    const std::vector<WeightedNormal> fewer(normals.begin(), normals.begin() + 2000);
    const double angle = 50 * std::numbers::pi / 180;
    const NormalSums of_few(fewer), of_many(normals);
    std::size_t few = 0, many = 0;
    for (std::size_t i = 0; i < 200; ++i) {
        const glm::dvec3 direction = normals[i].normal;
        glm::dvec3 sum{0};
        for (const WeightedNormal& other : fewer)
            if (glm::dot(other.normal, direction) >= std::cos(angle)) sum += other.normal * other.weight;
        // So few stand wide apart, and are decided one by one.
        CHECK(glm::length(of_few.within(direction, angle, &few) - sum) < 1e-9);
        of_many.within(direction, angle, &many);
    }
    CHECK(many < 6 * few);  // of 20 times as many
    const NormalSums same(std::vector<WeightedNormal>(100000, {{0, 0, 1}, 1}));
    std::size_t steps = 0;
    CHECK(glm::length(same.within({0, 0, 1}, angle, &steps) - glm::dvec3(0, 0, 1e5)) < 1e-6);
    CHECK(steps < 10);
}

TEST_CASE("geometry: a fan of very many triangles gets the normals that a fan of few has") {
    // A flat cone, whose tip is a corner of every triangle.
    const auto tip = [](int n) {
        Triangles t;
        t.positions.emplace_back(0, 0, 0.3);
        for (int i = 0; i < n; ++i)
            t.positions.emplace_back(std::cos(2 * std::numbers::pi * i / n),
                                     std::sin(2 * std::numbers::pi * i / n), 0);
        for (int i = 0; i < n; ++i) t.faces.push_back({{{0}, {1 + i}, {1 + (i + 1) % n}}});
        const Mesh mesh = mesh_of(t);
        REQUIRE(mesh.indices.size() == static_cast<std::size_t>(3 * n));
        float least = 1;
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
            least = std::min(least, mesh.normals[mesh.indices[i]].z);
        return least;
    };
    CHECK(tip(50) == doctest::Approx(1));
    CHECK(tip(200000) == doctest::Approx(1));  // by pairs it would take 4e10 of them
}
