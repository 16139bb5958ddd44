// Polygons cut into triangles: what is covered, and in how many steps.
#include "core/geometry/triangulate.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <random>
#include <set>

#include "tests/core/polygon_shapes.h"

using namespace nacre;
using namespace nacre::test;

namespace {

using Polygon = std::vector<glm::dvec3>;
using Triangle = std::array<std::size_t, 3>;

// On a slanting plane far from the origin, and of some size.
Polygon in_space(const std::vector<glm::dvec2>& flat, double size = 1) {
    const glm::dvec3 x = glm::normalize(glm::dvec3(1, 2, -1)), y = glm::normalize(glm::dvec3(3, -1, 1));
    Polygon polygon;
    for (const glm::dvec2 p : flat) polygon.push_back(size * (glm::dvec3(5, -7, 3) + p.x * x + p.y * y));
    return polygon;
}

glm::dvec3 area_vector(const Polygon& p, const Triangle& t) {
    return glm::cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]) / 2.0;
}

glm::dvec3 area_vector(const Polygon& p) {
    glm::dvec3 sum{0};
    for (std::size_t i = 1; i + 1 < p.size(); ++i) sum += area_vector(p, {0, i, i + 1});
    return sum;
}

// The triangles turn as the polygon does and have its area: they cover it, and nothing twice.
void check_covered(const Polygon& polygon) {
    const std::vector<Triangle> triangles = triangulated(polygon);
    REQUIRE(triangles.size() == polygon.size() - 2);
    const glm::dvec3 whole = area_vector(polygon);
    const double area = glm::length(whole);
    double sum = 0, least = 0;
    for (const Triangle& t : triangles) {
        const glm::dvec3 part = area_vector(polygon, t);
        sum += glm::length(part);
        least = std::min(least, glm::dot(part, whole) / area);
    }
    CHECK(sum == doctest::Approx(area).epsilon(1e-9));
    CHECK(least >= -1e-12 * area);
}

}  // namespace

TEST_CASE("triangulate: what is convex, concave, wound or jagged is covered") {
    for (const int n : {3, 4, 5, 6, 7, 12, 100, 1001}) check_covered(in_space(circle(n)));
    for (const int n : {6, 8, 50, 1000}) check_covered(in_space(star(n)));
    for (const int n : {3, 5, 9, 101, 1001}) check_covered(in_space(comb(n)));
    for (const int n : {200, 500, 2000}) check_covered(in_space(spiral(n)));
    for (unsigned seed = 0; seed < 200; ++seed)
        check_covered(in_space(ragged(5 + static_cast<int>(seed), seed)));
    for (int depth = 0; depth < 6; ++depth) check_covered(in_space(snowflake(depth)));
}

TEST_CASE("triangulate: of any size, and in any direction") {
    for (const double size : {1e-60, 1e-30, 1e30, 1e60}) check_covered(in_space(ragged(30, 3), size));
    for (const glm::dvec3 x : {glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1)})
        for (const double sign : {1.0, -1.0}) {
            const glm::dvec3 y = sign * glm::dvec3(x.z, x.x, x.y);
            Polygon polygon;
            for (const glm::dvec2 p : ragged(30, 4)) polygon.push_back(p.x * x + p.y * y);
            check_covered(polygon);
        }
}

TEST_CASE("triangulate: a quadrilateral is cut across its hollow, else from its first corner") {
    CHECK(triangulated(in_space({{0, 0}, {1, 0}, {1, 1}, {0, 1}})) ==
          std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}});
    for (std::size_t turn = 0; turn < 4; ++turn) {
        std::vector<glm::dvec2> dart{{0, 0}, {2, -1}, {0.5, 0}, {2, 1}};
        std::rotate(dart.begin(), dart.begin() + static_cast<std::ptrdiff_t>(turn), dart.end());
        std::reverse(dart.begin(), dart.end());
        check_covered(in_space(dart));
    }
}

TEST_CASE("triangulate: corners on a straight line leave no slivers") {
    // Each side of a square in ten.
    std::vector<glm::dvec2> square;
    const std::vector<glm::dvec2> corners{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    for (std::size_t side = 0; side < 4; ++side)
        for (int i = 0; i < 8; ++i)
            square.push_back(corners[side] + (corners[(side + 1) % 4] - corners[side]) * (i / 8.0));
    Polygon polygon;
    for (const glm::dvec2 p : square) polygon.emplace_back(p.x, p.y, 0);
    check_covered(polygon);
    for (const Triangle& t : triangulated(polygon)) CHECK(area_vector(polygon, t).z > 0);
}

TEST_CASE("triangulate: holes that are reached by an edge gone both ways stay open") {
    for (const int holes : {1, 2, 3, 10, 100}) {
        CAPTURE(holes);
        Polygon polygon;
        for (const glm::dvec2 at : plate(holes)) polygon.emplace_back(at.x, 0.6 * at.y, 0.8 * at.y);
        CHECK(glm::length(area_vector(polygon)) == doctest::Approx((3 * holes + 1) * (holes + 3) - holes));
        check_covered(polygon);
    }
}

TEST_CASE("triangulate: petals that share one corner") {
    for (const int count : {2, 3, 7, 100, 1000}) {
        CAPTURE(count);
        check_covered(in_space(petals(count)));
    }
}

TEST_CASE("triangulate: what is not flat is covered as it is seen along its mean normal") {
    // A saddle that leans most from every axis.
    const glm::dvec3 z = glm::normalize(glm::dvec3(1, 1, 1)), x = glm::normalize(glm::dvec3(1, -1, 0));
    const glm::dvec3 y = glm::cross(z, x);
    Polygon polygon;
    for (const glm::dvec2 p : circle(60))
        polygon.push_back(p.x * x + p.y * y + 0.9 * (p.x * p.x - p.y * p.y) * z);
    double seen = 0;
    for (const Triangle& t : triangulated(polygon)) {
        const double part = glm::dot(area_vector(polygon, t), z);
        CHECK(part > 0);
        seen += part;
    }
    CHECK(seen == doctest::Approx(glm::dot(area_vector(polygon), z)));
}

TEST_CASE("triangulate: what crosses itself or has no area is cut into some triangles") {
    std::mt19937 random(2);
    std::uniform_int_distribution<int> coordinate(0, 3);
    for (int i = 0; i < 3000; ++i) {
        Polygon polygon;
        const int n = 3 + i % 14;
        for (int k = 0; k < n; ++k)
            polygon.emplace_back(coordinate(random), coordinate(random), i % 3 ? 0 : coordinate(random));
        const std::vector<Triangle> triangles = triangulated(polygon);
        REQUIRE(triangles.size() == polygon.size() - 2);
        glm::dvec3 sum{0};
        for (const Triangle& t : triangles) {
            REQUIRE(std::set<std::size_t>(t.begin(), t.end()).size() == 3);
            REQUIRE(*std::max_element(t.begin(), t.end()) < polygon.size());
            sum += area_vector(polygon, t);
        }
        // Each way of cutting leaves this.
        REQUIRE(glm::length(sum - area_vector(polygon)) < 1e-9);
    }
    CHECK(triangulated(Polygon{{0, 0, 0}, {1, 0, 0}}).empty());
}

TEST_CASE("triangulate: the steps grow as n log n, with long thin spikes too") {
    for (const PolygonShape& shape : polygon_shapes()) {
        CAPTURE(shape.name);
        for (const int n : {300, 3000, 48000}) {
            const Polygon polygon = in_space(shape.make(n));
            std::size_t steps = 0;
            triangulated(polygon, &steps);
            CHECK(static_cast<double>(steps) < 10 * n_log_n(polygon.size()));
        }
    }
}

TEST_CASE("triangulate: what crosses itself or has no area takes no more than twice as many steps") {
    std::size_t none = 0;
    CHECK(triangulated(Polygon(48000, glm::dvec3(1)), &none).size() == 47998);
    CHECK(static_cast<double>(none) < 20 * n_log_n(48000));
    for (const PolygonShape& shape : polygon_shapes()) {
        CAPTURE(shape.name);
        Polygon polygon = in_space(shape.make(48000));
        std::shuffle(polygon.begin() + static_cast<std::ptrdiff_t>(polygon.size() / 2), polygon.end(),
                     std::mt19937(1));
        std::size_t steps = 0;
        CHECK(triangulated(polygon, &steps).size() == polygon.size() - 2);
        CHECK(static_cast<double>(steps) < 20 * n_log_n(polygon.size()));
    }
}
