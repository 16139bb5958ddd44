// Polygons cut into triangles: what is covered, and in how many steps.
#include "core/geometry/triangulate.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <numbers>
#include <random>
#include <set>
#include <string>

using namespace nacre;

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

std::vector<glm::dvec2> circle(int n) {
    std::vector<glm::dvec2> p;
    for (int i = 0; i < n; ++i)
        p.emplace_back(std::cos(2 * std::numbers::pi * i / n), std::sin(2 * std::numbers::pi * i / n));
    return p;
}

// Long thin points.
std::vector<glm::dvec2> star(int n) {
    std::vector<glm::dvec2> p = circle(n);
    for (std::size_t i = 0; i < p.size(); i += 2) p[i] *= 0.2;
    return p;
}

std::vector<glm::dvec2> comb(int n) {
    std::vector<glm::dvec2> p;
    for (int i = 0; i < n; ++i) p.emplace_back(i, i % 2 ? 0 : n);
    p.emplace_back(n, -1);
    p.emplace_back(-1, -1);
    return p;
}

// A band that winds inward, and comes back along itself.
std::vector<glm::dvec2> spiral(int n) {
    std::vector<glm::dvec2> p;
    const int half = n / 2;
    const auto at = [&](int i, double r) {
        const double turn = 2 * std::numbers::pi * 8 * i / half;
        p.emplace_back((r + 1.0 - 0.9 * i / half) * std::cos(turn),
                       (r + 1.0 - 0.9 * i / half) * std::sin(turn));
    };
    for (int i = 0; i < half; ++i) at(i, 0.02);
    for (int i = half - 1; i >= 0; --i) at(i, 0);
    return p;
}

std::vector<glm::dvec2> ragged(int n, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> radius(0.05, 1);
    std::vector<glm::dvec2> p = circle(n);
    for (glm::dvec2& corner : p) corner *= radius(random);
    return p;
}

// Each edge of Koch's curve is four of the next.
std::vector<glm::dvec2> snowflake(int depth) {
    std::vector<glm::dvec2> p = circle(3);
    for (; depth > 0; --depth) {
        std::vector<glm::dvec2> finer;
        for (std::size_t i = 0; i < p.size(); ++i) {
            const glm::dvec2 a = p[i], third = (p[(i + 1) % p.size()] - a) / 3.0;
            const glm::dvec2 outward(third.y, -third.x);
            finer.insert(finer.end(),
                         {a, a + third, a + 1.5 * third + std::sqrt(0.75) * outward, a + 2.0 * third});
        }
        p = finer;
    }
    return p;
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
    // A plate with square holes, which turn the other way: each joined to the one before, the first to a
    // corner of the plate. Every joining edge stands twice.
    for (const int holes : {1, 2, 3, 10, 100}) {
        const double breadth = 3 * holes + 1, height = holes + 3;
        const auto corner = [&](int hole) { return glm::dvec2(3 * hole + 1, holes - hole); };
        std::vector<glm::dvec2> p{{0, 0}, {breadth, 0}, {breadth, height}, {0, height}, {0, 0}};
        for (int i = 0; i < holes; ++i)
            for (const glm::dvec2 to : {glm::dvec2(0, 0), {0, 1}, {1, 1}, {1, 0}, {0, 0}})
                p.push_back(corner(i) + to);
        for (int i = holes - 2; i >= 0; --i) p.push_back(corner(i));
        CAPTURE(holes);
        Polygon polygon;
        for (const glm::dvec2 at : p) polygon.emplace_back(at.x, 0.6 * at.y, 0.8 * at.y);
        CHECK(glm::length(area_vector(polygon)) == doctest::Approx(breadth * height - holes));
        check_covered(polygon);
    }
}

TEST_CASE("triangulate: petals that share one corner") {
    for (const int petals : {2, 3, 7, 100, 1000}) {
        const std::vector<glm::dvec2> rim = circle(2 * petals);
        std::vector<glm::dvec2> p;
        for (std::size_t i = 0; i < rim.size(); i += 2) p.insert(p.end(), {{0, 0}, rim[i], rim[i + 1]});
        CAPTURE(petals);
        check_covered(in_space(p));
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

TEST_CASE("triangulate: the steps grow as n log n, with long thin spikes as n^1.5") {
    const std::vector<std::pair<std::string, std::function<std::vector<glm::dvec2>(int)>>> kinds = {
        {"circle", circle},
        {"star", star},
        {"comb", [](int n) { return comb(n + 1); }},
        {"spiral", spiral},
        {"ragged", [](int n) { return ragged(n, 1); }},
        {"snowflake", [](int n) { return snowflake(n > 10000 ? 7 : 5); }},
        {"straight",
         [](int n) { return std::vector<glm::dvec2>(static_cast<std::size_t>(n), glm::dvec2(1)); }},
        {"petals",
         [](int n) {
             std::vector<glm::dvec2> p = circle(n);
             for (std::size_t i = 0; i < p.size(); i += 3) p[i] = {0, 0};
             return p;
         }},
        {"crossing", [](int n) {
             std::vector<glm::dvec2> p = circle(n);
             std::shuffle(p.begin(), p.end(), std::mt19937(1));
             return p;
         }}};
    for (const auto& kind : kinds) {
        const std::string name = kind.first;
        const auto& shape = kind.second;
        std::size_t few = 0, many = 0;
        const Polygon small = in_space(shape(3000)), large = in_space(shape(48000));
        triangulated(small, &few);
        triangulated(large, &many);
        CAPTURE(name);
        CAPTURE(few);
        CAPTURE(many);
        // Of 16 times as many corners: n log n is 22 times as many steps, n^1.5 64, n^2 256.
        const double allowed = name == "comb" || name == "ragged" ? 100 : 32;
        const auto growth = [](std::size_t now, std::size_t before) {
            return static_cast<double>(now) / static_cast<double>(before);
        };
        CHECK(growth(many, few) < allowed * growth(large.size(), small.size()) / 16);
        CHECK(static_cast<double>(many) < 64 * static_cast<double>(large.size()) * std::log2(large.size()));
    }
}
