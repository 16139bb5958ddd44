// What is selected on the canvas, and that the tools keep to it.
#include <doctest/doctest.h>

#include "core/design/design_file.h"
#include "tests/designer/canvas_rig.h"

using namespace nacre;
using nacre::test::CanvasRig;

namespace {

// The right of the facets' view is the left of the highlight's.
const std::string right_half =
    "key W\nframes 30\ndrag \"Canvas\":0.02,0.02 \"Canvas\":0.5,0.98 4\nframes 30\n";

}  // namespace

TEST_CASE("selection: a rectangle and a lasso, in each view; a click selects nothing") {
    for (const char* view : {"", "click \"Seen as\"\n", "click \"Dome\"\nframes 5\n"}) {
        CAPTURE(view);
        CanvasRig r;
        const Design before = r.document().design;
        r.play(std::string(view) +
               "key W\nframes 30\nmove \"Canvas\":@20,0\nframes 2\nmove \"Canvas\":0.3,0.3\n"
               "down left\nmove \"Canvas\":0.7,0.7\nframes 2");
        CHECK(r.canvas().selecting);
        r.play("up left\nframes 30");
        REQUIRE(r.canvas().selection);
        CHECK(!r.canvas().selecting);
        CHECK(r.selected(10, 70) > 0.99);
        CHECK(r.selected(85, 0) < 0.01);
        r.play("click \"Canvas\":@60,0\nframes 2");
        CHECK(!r.canvas().selection);
        r.play(
            "key Q\nframes 30\nmove \"Canvas\":@30,0\ndown left\nmove \"Canvas\":@30,60\nmove "
            "\"Canvas\":@30,120\n"
            "move \"Canvas\":@30,180\nmove \"Canvas\":@30,240\nmove \"Canvas\":@30,300\nup left\nframes 2");
        REQUIRE(r.canvas().selection);
        CHECK(r.selected(0, 0) > 0.99);
        CHECK(r.selected(23, 90) > 0.99);
        CHECK(r.selected(34, 90) < 0.01);
        CHECK(r.document().design == before);
        CHECK(!r.document().history.can_undo());
    }
}

TEST_CASE("selection: Shift adds, Ctrl or Alt takes away; Escape lets go of what is being marked alone") {
    CanvasRig r;
    r.play("key W\nframes 30\ndrag \"Canvas\":0.3,0.4 \"Canvas\":0.4,0.6 4\nframes 30");
    const auto first = r.canvas().selection;
    REQUIRE(first);
    r.play_with(false, true, false, "drag \"Canvas\":0.6,0.4 \"Canvas\":0.7,0.6 4\nframes 30");
    CHECK(r.canvas().selection->outlines(false).size() == 2);
    r.play_with(true, false, false, "drag \"Canvas\":0.2,0.2 \"Canvas\":0.5,0.8 4\nframes 30");
    CHECK(r.canvas().selection->outlines(false).size() == 1);
    r.play_with(false, false, true, "drag \"Canvas\":0.55,0.45 \"Canvas\":0.75,0.55 4\nframes 30");
    CHECK(r.canvas().selection->outlines(false).size() == 2);
    const auto kept = r.canvas().selection;
    r.play_with(false, true, false, "click \"Canvas\":0.9,0.9\nframes 30");
    CHECK(r.canvas().selection == kept);
    r.play(
        "move \"Canvas\":0.3,0.3\ndown left\nmove \"Canvas\":0.6,0.6\nframes 2\nkey Escape\nframes 2\nup "
        "left\nframes 2");
    CHECK(r.canvas().selection == kept);
    CHECK(!r.canvas().selecting);
    r.play("key Escape\nframes 2");
    CHECK(r.canvas().selection == kept);
}

TEST_CASE("selection: all, none and inverted, by key and in the search") {
    CanvasRig r;
    r.play("key Ctrl+A\nframes 2");
    REQUIRE(r.canvas().selection);
    CHECK(r.selected(80, 10) > 0.99);
    r.play("key Ctrl+Shift+A\nframes 2");
    CHECK(!r.canvas().selection);
    r.play(right_half);
    CHECK(r.selected(40, 0) > 0.99);
    r.play("key Ctrl+Shift+I\nframes 2");
    CHECK(r.selected(40, 0) < 0.01);
    CHECK(r.selected(40, 180) > 0.99);
    r.play("key Ctrl+K\nframes 3\ntext \"select none\"\nframes 3\nkey Enter\nframes 3");
    CHECK(!r.canvas().selection);
    r.play("key Ctrl+K\nframes 3\ntext \"lasso\"\nframes 3\nkey Enter\nframes 3");
    CHECK(r.canvas().tool == ui::CanvasTool::select_lasso);
    // A name that is typed is selected as text.
    r.play("click \"Layer name\"\nkey Ctrl+A\nframes 3");
    CHECK(!r.canvas().selection);
}

TEST_CASE(
    "selection: brush, stamp, fill and gradient keep to it, also on the object and on a layer that leans") {
    for (const char* tool : {"B", "T", "F", "D"}) {
        CAPTURE(tool);
        CanvasRig r;
        r.canvas().brush = {.radius = 40, .hardness = 1, .flow = 1};
        r.play(right_half + "click \"New painted layer\"");
        r.layers()[1].tilt = 20;
        r.layers()[1].azimuth = 100;
        r.document().commit();
        r.play("key " + std::string(tool) +
               "\nframes 30\ndrag \"Canvas\":@10,0 \"Canvas\":@60,2 6\nframes 3");
        const glm::dmat3 back = glm::transpose(layer_frame(r.layers()[1]));
        const auto value = [&](double theta, double phi) {
            return r.value(1, back * polar_direction(theta, phi));
        };
        CHECK(raster_mass(r.raster(1)) > 0);
        for (const double theta : {3.0, 10.0, 30.0, 60.0})
            for (const double phi : {135.0, 180.0, 225.0}) CHECK(value(theta, phi) == 0);
    }
}

TEST_CASE("selection: a fill beside it begins no layer") {
    CanvasRig r;
    r.play(right_half + "key F\nframes 30\nclick \"Canvas\":@40,180\nframes 3");
    CHECK(r.layers().size() == 1);
    CHECK(!r.document().history.can_undo());
    r.play("click \"Canvas\":@40,0\nframes 3");
    CHECK(r.layers().size() == 2);
}

TEST_CASE("selection: its rim is one texel wide; what is selected is filled and cleared in one step each") {
    CanvasRig r;
    r.play(right_half + "click \"New painted layer\"\nframes 30");
    const Design blank = r.document().design;
    r.canvas().brush = {.value = 0.8};
    r.play("key Shift+Backspace\nframes 3");
    const Design filled = r.document().design;
    CHECK(r.value(1, 1.2, 0) == doctest::Approx(0.8));
    CHECK(r.value(1, 1.2, 180) == 0);
    CHECK(r.value(1, 85, 60) == doctest::Approx(0.8));
    CHECK(r.layers()[1].enabled);
    r.play("key Ctrl+Shift+I\nframes 2\nkey Ctrl+Shift+I\nframes 2\nkey W\nframes 30\n");
    r.play_with(true, false, false, "drag \"Canvas\":0.02,0.02 \"Canvas\":0.98,0.5 4\nframes 30");
    r.play("key Delete\nframes 3");
    CHECK(r.value(1, 40, 45) == doctest::Approx(0.8).epsilon(0.8));
    CHECK(r.value(1, 40, 45) + r.value(1, 40, 315) == doctest::Approx(0.8));
    r.play("key Ctrl+Z\nframes 2");
    CHECK(r.document().design == filled);
    r.play("key Ctrl+Z\nframes 2");
    CHECK(r.document().design == blank);
    // Of a lobe that is not painted there is nothing to clear.
    r.play("key 1\nframes 2\nkey Delete\nframes 2");
    CHECK(r.document().design == blank);
}

TEST_CASE("selection: it goes with the design that it was made on") {
    CanvasRig r;
    r.play("key Ctrl+A\nframes 2");
    REQUIRE(r.canvas().selection);
    r.play("key Ctrl+N\nframes 4");
    CHECK(!r.canvas().selection);
}
