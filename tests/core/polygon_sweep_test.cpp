// Polygons swept into triangles: what is covered, what is refused, and in how many steps.
#include "core/geometry/polygon_sweep.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "core/geometry/corner_tree.h"
#include "tests/core/polygon_shapes.h"

using namespace nacre;
using namespace nacre::test;

namespace {

using Triangle = std::array<std::size_t, 3>;

// Of a size about 1, turned by an angle.
Flat placed(Flat polygon, double angle) {
    double size = 0;
    for (const glm::dvec2 p : polygon) size = std::max({size, std::fabs(p.x), std::fabs(p.y)});
    for (glm::dvec2& p : polygon)
        p = glm::dvec2(std::cos(angle) * p.x - std::sin(angle) * p.y,
                       std::sin(angle) * p.x + std::cos(angle) * p.y) /
            size;
    return polygon;
}

std::vector<std::size_t> all_of(const Flat& polygon) {
    std::vector<std::size_t> corners(polygon.size());
    std::iota(corners.begin(), corners.end(), std::size_t{0});
    return corners;
}

double area(const Flat& p) {
    double sum = 0;
    for (std::size_t i = 1; i + 1 < p.size(); ++i) sum += turn(p[0], p[i], p[i + 1]);
    return sum;
}

// No triangle turns clockwise and the areas add up: the polygon is covered, and nothing twice.
std::size_t check_swept(const Flat& polygon) {
    std::vector<Triangle> triangles;
    std::size_t steps = 0;
    REQUIRE(sweep_polygon(polygon, all_of(polygon), triangles, steps));
    REQUIRE(triangles.size() == polygon.size() - 2);
    const double whole = area(polygon);
    double sum = 0, least = 0;
    std::set<std::size_t> used;
    for (const auto& [a, b, c] : triangles) {
        const double part = turn(polygon[a], polygon[b], polygon[c]);
        sum += part;
        least = std::min(least, part);
        used.insert({a, b, c});
    }
    CHECK(sum == doctest::Approx(whole).epsilon(1e-9));
    CHECK(least >= -1e-12 * whole);
    CHECK(used.size() == polygon.size());
    return steps;
}

}  // namespace

TEST_CASE("sweep: every shape is covered, turned by any angle, in about n log n steps") {
    for (const PolygonShape& shape : polygon_shapes())
        for (const int n : {300, 3000, 24000})
            for (const double angle : {0.0, 0.7, 1.5707963267948966, 4.0}) {
                CAPTURE(shape.name);
                CAPTURE(n);
                CAPTURE(angle);
                const Flat polygon = placed(shape.make(n), angle);
                CHECK(static_cast<double>(check_swept(polygon)) < 2 * n_log_n(polygon.size()));
            }
}

TEST_CASE("sweep: small ones") {
    for (int n = 3; n < 40; ++n)
        for (unsigned seed = 0; seed < 50; ++seed) check_swept(placed(ragged(n, seed), 0.1 * seed));
    for (int holes = 1; holes < 12; ++holes) check_swept(placed(plate(holes), 0.3 * holes));
    for (int count = 2; count < 12; ++count) check_swept(placed(petals(count), 0.3 * count));
}

TEST_CASE("sweep: corners on a straight line leave no slivers") {
    for (const int parts : {1, 2, 8}) {
        const Flat square = parted_square(parts);
        std::vector<Triangle> triangles;
        std::size_t steps = 0;
        REQUIRE(sweep_polygon(square, all_of(square), triangles, steps));
        for (const auto& [a, b, c] : triangles) CHECK(turn(square[a], square[b], square[c]) > 0);
    }
}

TEST_CASE("sweep: of some corners in their order, whatever else there is") {
    const Flat points{{9, 9}, {0, 0}, {1, 0}, {-5, 3}, {1, 1}, {0, 1}};
    std::vector<Triangle> triangles{{7, 8, 9}};
    std::size_t steps = 0;
    REQUIRE(sweep_polygon(points, std::vector<std::size_t>{1, 2, 4, 5}, triangles, steps));
    REQUIRE(triangles.size() == 3);
    double sum = 0;
    for (std::size_t i = 1; i < 3; ++i) {
        const auto& [a, b, c] = triangles[i];
        const double part = turn(points[a], points[b], points[c]);
        CHECK(part > 0);
        sum += part;
    }
    CHECK(sum == 2);
}

TEST_CASE("sweep: a corner that touches an edge, from either side") {
    // A tip that hangs from the top, down to the bottom edge; and a finger in a pocket, up to its wall. Over
    // the edge by rounding too.
    for (const double over : {0.0, 3e-16, -3e-16}) {
        Flat tip{{0, 0}, {1, 0}, {1, 1}, {0.6, 1}, {0.5, over}, {0.4, 1}, {0, 1}};
        Flat finger{{0, 0},        {4, 0},     {4, 1}, {1, 1}, {1, 3}, {2.5, 3}, {2.5, 2.2},
                    {1 + over, 2}, {2.7, 1.8}, {3, 3}, {4, 3}, {4, 4}, {0, 4}};
        for (int quarter = 0; quarter < 4; ++quarter) {
            CAPTURE(over);
            CAPTURE(quarter);
            check_swept(tip);
            check_swept(finger);
            for (glm::dvec2& p : tip) p = {-p.y, p.x};
            for (glm::dvec2& p : finger) p = {-p.y, p.x};
        }
    }
}

TEST_CASE("sweep: what crosses itself, turns clockwise or has no area is refused, and adds nothing") {
    Flat clockwise = circle(12);
    std::reverse(clockwise.begin(), clockwise.end());
    for (const Flat& polygon :
         {Flat{{0, 0}, {1, 1}, {1, 0}, {0, 1}}, Flat{{0, 0}, {3, 0}, {3, 1}, {1, -1}, {1, 2}, {0, 2}},
          clockwise, Flat(9, glm::dvec2(1)), Flat{{0, 0}, {1, 0}, {2, 0}, {1, 0}}}) {
        std::vector<Triangle> triangles{{0, 1, 2}};
        std::size_t steps = 0;
        CHECK_FALSE(sweep_polygon(polygon, all_of(polygon), triangles, steps));
        CHECK(triangles.size() == 1);
    }
}
