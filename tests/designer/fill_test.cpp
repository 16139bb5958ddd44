// Fill and gradient, on the canvas as it is turned and on the object.
#include <doctest/doctest.h>

#include "tests/designer/canvas_rig.h"

using namespace nacre;
using nacre::test::CanvasRig;

namespace {

constexpr const char* ring = "click \"Ring\"\ndrag \"Canvas\":@0,0 \"Canvas\":@40,0\nframes 30\n";

}  // namespace

TEST_CASE("fill: a click fills what a ring goes around, in one step of undo, whatever the view") {
    for (const char* view : {"", "click \"Seen as\"\n", "click \"Dome\"\nframes 5\n"}) {
        CAPTURE(view);
        CanvasRig r;
        r.canvas().brush = {.radius = 4, .hardness = 0.9, .flow = 1};
        r.play(std::string(view) + ring);
        const Design before = r.document().design;
        r.canvas().brush.value = 0.5;
        r.play("key F\nclick \"Canvas\":@20,250\nframes 2");
        CHECK(r.canvas().tool == ui::CanvasTool::fill);
        CHECK(r.layers().size() == 2);
        CHECK(r.value(1, 20, 250) == doctest::Approx(0.5));
        CHECK(r.value(1, 30, 10) == doctest::Approx(0.5));
        CHECK(r.value(1, 60, 10) == 0);
        CHECK(r.layers()[1].weight > before.distribution.layers[1].weight);
        r.play("key Ctrl+Z");
        CHECK(r.document().design == before);
    }
}

TEST_CASE("fill: with symmetry, tolerance and Combine of the toolbar; on a lobe a new layer begins") {
    CanvasRig r;
    r.canvas().brush.value = 0.4;
    r.play("key F\nclick \"Canvas\":@30,30\nframes 30");
    REQUIRE(r.layers().size() == 2);
    CHECK(r.value(1, 70, 200) == doctest::Approx(0.4));
    r.canvas().brush.blend = Blend::add;
    r.canvas().brush.opacity = 0.5;
    r.play("click \"Canvas\":@30,30\nframes 30");
    CHECK(r.value(1, 70, 200) == doctest::Approx(0.6));
    r.canvas().brush = {.radius = 4, .hardness = 0.9, .flow = 1};
    r.play(
        "click \"Symmetry\"\nclick \"Symmetry Mirror x\"\nclick \"Ring\"\n"
        "drag \"Canvas\":@50,0 \"Canvas\":@65,0\nframes 30");
    r.canvas().brush.value = 0.1;
    r.play("key F\nclick \"Canvas\":@50,0\nframes 30");
    CHECK(r.value(1, 50, 0) == doctest::Approx(0.1));
    CHECK(r.value(1, 50, 180) == r.value(1, 50, 0));
    CHECK(r.value(1, 0, 0) == doctest::Approx(0.6));
    // All is like the rest.
    r.canvas().tolerance = 1;
    r.play("click \"Canvas\":@5,5\nframes 30");
    CHECK(r.value(1, 50, 0) == doctest::Approx(0.1));
    CHECK(r.value(1, 65, 0) == doctest::Approx(0.1));
    CHECK(r.value(1, 80, 100) == doctest::Approx(0.1));
}

TEST_CASE("fill: on the object, under the pointer") {
    CanvasRig r;
    r.canvas().brush = {.radius = 6, .hardness = 0.9, .flow = 1};
    r.play("wait\n" + std::string(ring));
    r.canvas().brush.value = 0.5;
    r.play("key F\nmove \"Preview\":0.5,0.5\nframes 3");
    REQUIRE(r.designer().preview.pointed_at());
    const dvec3 there = *r.designer().preview.pointed_at();
    r.play("click \"Preview\":0.5,0.5\nframes 3");
    CHECK(r.value(1, there) == doctest::Approx(0.5));
    CHECK(r.value(1, 70, 0) == 0);
}

TEST_CASE("gradient: from the press to the pointer, linear and radial, one step each; Escape takes it back") {
    CanvasRig r;
    r.play("key D\nframes 30\ndrag \"Canvas\":@60,180 \"Canvas\":@60,0 10\nframes 30");
    const Design linear = r.document().design;
    CHECK(r.value(1, 60, 180) > 0.98);
    CHECK(r.value(1, 0, 0) == doctest::Approx(0.5).epsilon(0.02));
    CHECK(r.value(1, 60, 0) < 0.02);
    CHECK(r.value(1, 30, 180) == doctest::Approx(0.75).epsilon(0.02));
    CHECK(r.value(1, 80, 180) == doctest::Approx(1));
    r.canvas().brush.blend = Blend::multiply;
    r.canvas().brush.value = 0;
    r.play(
        "click \"Gradient form\"\nframes 2\nclick \"Gradient form Radial\"\nframes 30\n"
        "drag \"Canvas\":@30,180 \"Canvas\":@0,0 10\nframes 30");
    CHECK(r.value(1, 30, 180) < 0.02);
    CHECK(r.value(1, 0, 0) == doctest::Approx(0.5).epsilon(0.03));
    CHECK(r.value(1, 15, 180) == doctest::Approx(0.625 / 2).epsilon(0.03));
    CHECK(r.value(1, 80, 180) == doctest::Approx(1));
    const Design radial = r.document().design;
    r.play("move \"Canvas\":@10,0\ndown left\nmove \"Canvas\":@70,0\nframes 2");
    CHECK(r.document().design != radial);
    r.play("key Escape\nframes 2\nup left\nframes 2");
    CHECK(r.document().design == radial);
    r.play("key Ctrl+Z");
    CHECK(r.document().design == linear);
    r.play("key Ctrl+Z");
    CHECK(!r.document().history.can_undo());
}

TEST_CASE("gradient: a click in place changes nothing") {
    CanvasRig r;
    const Design before = r.document().design;
    r.play("click \"Gradient\"\nclick \"Canvas\":@20,0\nframes 3");
    CHECK(r.document().design == before);
    CHECK(!r.document().history.can_undo());
    CHECK(r.designer().layers.chosen == 0);
    r.play("drag \"Canvas\":@20,0 \"Canvas\":@50,0\nframes 30");
    CHECK(r.layers().size() == 2);
}
