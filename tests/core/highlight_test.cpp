#include "core/paint/highlight.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/paint/brush.h"
#include "core/paint/painted_layer.h"
#include "core/paint/raster_texels.h"
#include "core/paint/stroke.h"
#include "tests/core/random_directions.h"

using namespace nacre;

namespace {

constexpr double radians = std::numbers::pi / 180;

dvec3 polar(double theta, double phi) { return test::polar(std::cos(theta * radians), phi * radians); }

// Dabs of the brush, one on the other.
Raster dabs(const std::vector<dvec3>& places, double radius = 8) {
    Raster raster = *blank_raster();
    for (const dvec3& place : places)
        raster = *Stroke(raster, {PaintTool::paint, {radius, 0.3, 0.8}, {}, nullptr}, place).raster();
    return raster;
}

dvec3 mean_of(const Raster& raster) {
    dvec3 sum{0};
    for (int row = 0; row < raster.height; ++row)
        for (int column = 0; column < raster.width; ++column) {
            const glm::dvec2 point = texel_point(raster.width, row, column);
            if (holds_facets(point))
                sum += static_cast<double>(
                           raster.values[static_cast<std::size_t>(row * raster.width + column)]) *
                       disk_direction(point);
        }
    return sum;
}

double degrees_between(dvec3 a, dvec3 b) {
    return angle_between(glm::normalize(a), glm::normalize(b)) / radians;
}

}  // namespace

TEST_CASE(
    "highlight: one of two is carried by 20 degrees, the other stays to the bit, and no facet is lost") {
    const Raster both = dabs({polar(30, 0), polar(35, 180)}), other = dabs({polar(35, 180)});
    const auto highlight = Highlight::under(both, polar(32, 3));
    REQUIRE(highlight);
    CHECK(highlight->rest() == other);
    for (const double phi : {0.0, 77.0, 180.0}) {
        const dvec3 from = polar(32, 3);
        const dvec3 to = shortest_rotation({0, 0, 1}, from) * polar(20, phi);
        const auto after = highlight->carried(to);
        REQUIRE(after);
        CHECK(raster_mass(*after) == doctest::Approx(raster_mass(both)).epsilon(1e-6));
        const dvec3 moved = mean_of(*after) - mean_of(other), before = mean_of(both) - mean_of(other);
        CHECK(degrees_between(moved, shortest_rotation(from, to) * before) < 0.02);
        CHECK(glm::length(moved) == doctest::Approx(glm::length(before)).epsilon(1e-3));
    }
}

TEST_CASE("highlight: a stroke is one, with its ripple and its soft edge") {
    Stroke stroke(*blank_raster(), {PaintTool::paint, {6, 0.2, 0.4}, {}, nullptr}, polar(40, 0));
    for (int phi = 1; phi <= 150; ++phi) stroke.move_to(polar(40, phi));
    const auto highlight = Highlight::under(*stroke.raster(), polar(40, 20));
    REQUIRE(highlight);
    CHECK(raster_mass(highlight->rest()) == 0);
    CHECK(!Highlight::under(*stroke.raster(), polar(60, 200)));
}

TEST_CASE("highlight: where two meet, the valley parts them") {
    const Raster both = dabs({polar(20, 0), polar(20, 50)}, 10);
    const auto one = Highlight::under(both, polar(20, 0)), two = Highlight::under(both, polar(20, 50));
    REQUIRE(one);
    REQUIRE(two);
    CHECK(raster_mass(one->part()) == doctest::Approx(raster_mass(two->part())).epsilon(0.02));
    CHECK(raster_mass(one->part()) + raster_mass(two->part()) ==
          doctest::Approx(raster_mass(both)).epsilon(1e-6));
    CHECK(degrees_between(mean_of(one->part()), polar(20, 0)) < 1.5);
}

TEST_CASE("highlight: at the rim it keeps its facets, and values stay in [0, 1]") {
    const dvec3 far = polar(40, 270);
    const Raster raster = dabs({polar(60, 90), polar(84, 90), far});
    const auto highlight = Highlight::under(raster, polar(60, 90));
    REQUIRE(highlight);
    const auto value = [&](const Raster& of) { return raster_value(of.values, of.width, disk_point(far)); };
    for (const double theta : {75.0, 84.0, 90.0, 110.0}) {
        CAPTURE(theta);
        const auto after = highlight->carried(polar(theta, 90));
        REQUIRE(after);
        CHECK(*std::min_element(after->values.begin(), after->values.end()) >= 0);
        CHECK(*std::max_element(after->values.begin(), after->values.end()) <= 1);
        const double unit = value(raster) / value(*after);
        CHECK(unit >= 1);
        CHECK(unit * raster_mass(*after) == doctest::Approx(raster_mass(raster)).epsilon(1e-6));
    }
}
