#include "core/paint/hemisphere_view.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <utility>

#include "core/model/disk.h"
#include "tests/core/random_directions.h"

using namespace nacre;

namespace {

HemisphereCamera camera_of(bool dome, bool below, double zoom, glm::dvec2 centre, bool highlight = false) {
    return {.highlight = highlight,
            .dome = dome,
            .below = below,
            .centre = centre,
            .zoom = zoom,
            .yaw = 40,
            .pitch = 35};
}

}  // namespace

TEST_CASE("disk: directions and points are each other's inverse, and areas are solid angles over 2") {
    Random random(1);
    for (int i = 0; i < 1000; ++i) {
        dvec3 h = test::random_direction(random);
        if (i % 2) h.z = -h.z;
        CHECK(glm::length(disk_direction(disk_point(h)) - h) < 1e-12);
    }
    CHECK(glm::length(disk_point({1, 0, 0}) - glm::dvec2(1, 0)) < 1e-15);
    CHECK(glm::length(disk_point({0, 0, -1})) == doctest::Approx(std::numbers::sqrt2));
    // The cap within theta has the solid angle 2 pi (1 - cos theta) and the area pi r^2.
    const double theta = 0.7;
    const double r = glm::length(disk_point({std::sin(theta), 0, std::cos(theta)}));
    CHECK(2 * r * r == doctest::Approx(2 * (1 - std::cos(theta))));
}

TEST_CASE("view: what lies under a normal's pixel is the normal") {
    Random random(2);
    for (const bool highlight : {false, true})
        for (const auto& [dome, below] :
             {std::pair(false, false), {false, true}, {true, false}, {true, true}}) {
            const HemisphereView view(camera_of(dome, below, 1.5, {0.1, -0.2}, highlight), {500, 400});
            int seen = 0;
            for (int i = 0; i < 500; ++i) {
                dvec3 h = test::random_direction(random);
                if (i % 2) h.z = -h.z;
                const auto under = view.direction(view.pixel(h));
                if (view.hidden(h)) {
                    if (under) CHECK(glm::length(*under - h) > 1e-9);
                    continue;
                }
                ++seen;
                REQUIRE(under);
                CHECK(glm::length(*under - h) < 1e-6);
                CHECK(glm::length(view.nearest_direction(view.pixel(h)) - h) < 1e-6);
            }
            CHECK(seen > 100);
        }
}

TEST_CASE("view: beside the picture there is no normal, and the nearest lies on the rim") {
    const HemisphereView view({.highlight = false}, {300, 300});
    CHECK(!view.direction({2, 2}));
    CHECK(view.coverage({2, 2}) == 0);
    CHECK(view.coverage({150, 150}) == 1);
    const dvec3 rim = view.nearest_direction({299, 150});
    CHECK(rim.z == doctest::Approx(0).epsilon(1e-9));
    CHECK(rim.x > 0.999);
    CHECK(view.direction({150, 40})->y > 0.5);  // +y is up
    // Of the highlight: facets that are tilted down shine above its middle.
    CHECK(HemisphereView({}, {300, 300}).direction({150, 40})->y < -0.5);
    CHECK(HemisphereView({}, {300, 300}).nearest_direction({299, 150}).x < -0.999);
}

TEST_CASE("view: the wheel keeps what is under the pointer, and all is shown again at zoom 1") {
    const HemisphereView view({}, {400, 300});
    const glm::dvec2 pixel(240, 120);
    const HemisphereView closer(zoomed(view, pixel, 3), {400, 300});
    CHECK(closer.camera().zoom == doctest::Approx(3));
    CHECK(glm::length(*closer.direction(pixel) - *view.direction(pixel)) < 1e-9);
    const HemisphereCamera back = zoomed(closer, {10, 10}, 1e-3);
    CHECK(back.zoom == zoom_min);
    CHECK(glm::length(back.centre) == 0);
    CHECK(zoomed(closer, pixel, 1e6).zoom == zoom_max);
}

TEST_CASE("view: a drag moves the picture with the pointer, but not out of sight") {
    const HemisphereView view(camera_of(false, false, 4, {0.2, 0.1}), {400, 300});
    const auto grabbed = *view.direction({200, 150});
    const HemisphereView moved(panned(view, {30, -20}), {400, 300});
    CHECK(glm::length(*moved.direction({230, 130}) - grabbed) < 1e-9);
    const HemisphereView far(panned(view, {1e6, 0}), {400, 300});
    CHECK(glm::length(far.camera().centre) <= 1);
}
