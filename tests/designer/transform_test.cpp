// The box of handles about what is painted or selected.
#include <doctest/doctest.h>

#include <fmt/format.h>

#include "tests/designer/canvas_rig.h"

using namespace nacre;
using nacre::test::CanvasRig;

namespace {

struct TransformRig : CanvasRig {
    TransformRig() {
        canvas().brush = {.radius = 8, .hardness = 0.9, .flow = 1};
        play("key B\nframes 30\nclick \"Canvas\":@40,0\nframes 30");
        painted = document().design;
        play("key C\nframes 3");
    }

    // A point of the box, in the canvas' rectangle.
    std::string place(dvec2 own) {
        const ImVec4 canvas_at = *stage.items().rectangle("Canvas");
        const glm::dvec2 size(canvas_at.z - canvas_at.x, canvas_at.w - canvas_at.y);
        const glm::dvec2 at = HemisphereView(canvas().camera, size).disk_pixel(box().at(own)) / size;
        return fmt::format("\"Canvas\":{:.5f},{:.5f}", at.x, at.y);
    }
    const DiskBox& box() { return canvas().transform.value().box; }
    bool pending() { return canvas().transform && canvas().transform->paint; }

    Design painted;
};

}  // namespace

TEST_CASE("transform: taking the tool changes nothing, a drag moves, Enter makes one step of undo") {
    TransformRig r;
    CHECK(r.document().design == r.painted);
    REQUIRE(r.canvas().transform);
    r.play("drag \"Canvas\":@40,0 \"Canvas\":@40,180 6\nframes 30");
    CHECK(r.pending());
    CHECK(r.value(1, 40, 180) > 0.9);
    CHECK(r.value(1, 40, 0) == 0);
    r.play("drag \"Canvas\":@40,180 \"Canvas\":@40,90 6\nframes 30");
    CHECK(r.value(1, 40, 90) > 0.9);
    CHECK(r.value(1, 40, 180) == 0);
    CHECK(r.document().history.current() == r.painted);
    r.play("key Enter\nframes 3");
    CHECK(!r.pending());
    CHECK(r.document().history.current() == r.document().design);
    r.play("key Ctrl+Z\nframes 3");
    CHECK(r.document().design == r.painted);
    r.play("key Ctrl+Y\nframes 3");
    CHECK(r.value(1, 40, 90) > 0.9);
}

TEST_CASE("transform: Escape takes a drag back, and at rest all of it; Ctrl+Z does too") {
    TransformRig r;
    r.play("drag \"Canvas\":@40,0 \"Canvas\":@40,180 6\nframes 30");
    const Design moved = r.document().design;
    r.play(
        "move \"Canvas\":@40,180\ndown left\nmove \"Canvas\":@10,180\nframes 2\nkey Escape\nframes 3\nup "
        "left\nframes 3");
    CHECK(r.pending());
    CHECK(r.document().design == moved);
    r.play("key Escape\nframes 3");
    CHECK(!r.pending());
    CHECK(r.document().design == r.painted);
    CHECK(r.canvas().tool == ui::CanvasTool::transform);
    r.play("drag \"Canvas\":@40,0 \"Canvas\":@40,180 6\nframes 30\nkey Ctrl+Z\nframes 3");
    CHECK(!r.pending());
    CHECK(r.document().design == r.painted);
}

TEST_CASE("transform: a click outside applies, in the canvas, elsewhere, and by taking another tool") {
    for (const char* elsewhere :
         {"click \"Canvas\":@70,90", "click \"Material\"", "key B", "click \"Apply transform\""}) {
        CAPTURE(elsewhere);
        TransformRig r;
        r.play("drag \"Canvas\":@40,0 \"Canvas\":@40,180 6\nframes 30\n" + std::string(elsewhere) +
               "\nframes 30");
        CHECK(!r.pending());
        CHECK(r.value(1, 40, 180) > 0.9);
        CHECK(r.document().history.current() == r.document().design);
        r.play("key Ctrl+Z\nframes 3");
        CHECK(r.document().design == r.painted);
    }
    TransformRig r;
    r.play("drag \"Canvas\":@40,0 \"Canvas\":@40,180 6\nframes 30\nclick \"Cancel transform\"\nframes 3");
    CHECK(r.document().design == r.painted);
}

TEST_CASE("transform: a change elsewhere is a step of its own") {
    TransformRig r;
    r.play(
        "drag \"Canvas\":@40,0 \"Canvas\":@40,180 6\nframes 30\n"
        "drag \"Intensity\":0.5 \"Intensity\":0.2 3\nframes 60");
    CHECK(r.document().design.specular.intensity < 1);
    r.play("key Ctrl+Z\nframes 3");
    CHECK(r.document().design.specular.intensity == 1);
    CHECK(r.value(1, 40, 180) > 0.9);
    r.play("key Ctrl+Z\nframes 3");
    CHECK(r.document().design == r.painted);
}

TEST_CASE("transform: a corner stretches, the knob turns, in every view") {
    for (const char* view : {"", "click \"Seen as\"\nframes 3\n", "click \"Dome\"\nframes 5\n"}) {
        CAPTURE(view);
        TransformRig r;
        r.play(view);
        const DiskBox before = r.box();
        r.play("drag " + r.place({1, 1}) + " " + r.place({1.8, 1.4}) + " 6\nframes 30");
        CHECK(glm::length(r.box().right) == doctest::Approx(1.4 * glm::length(before.right)).epsilon(0.05));
        CHECK(glm::length(r.box().up) == doctest::Approx(1.2 * glm::length(before.up)).epsilon(0.05));
        CHECK(glm::length(r.box().at({-1, -1}) - before.at({-1, -1})) < 0.01);
        CHECK(r.value(1, disk_direction(r.box().at({0.5, 0}))) > 0.9);
        CHECK(r.value(1, disk_direction(r.box().at({0, 0.5}))) > 0.9);
        CHECK(r.value(1, disk_direction(r.box().at({1.1, 0}))) == 0);
    }
}

TEST_CASE("transform: of what is selected alone, which goes along; combined as the list says") {
    TransformRig r;
    r.canvas().brush.value = 0.5;
    r.play(
        "key B\nframes 30\nclick \"Canvas\":@40,180\nframes 30\nkey W\nframes 30\nmove \"Canvas\":@30,20\n");
    r.play("frames 30");
    const Design both = r.document().design;
    // About the one at azimuth 180, which stands at the right of the highlight's view.
    r.play("drag \"Canvas\":0.55,0.3 \"Canvas\":0.95,0.7 4\nframes 30\nkey C\nframes 3");
    REQUIRE(r.selected(40, 180) > 0.99);
    r.canvas().brush.blend = Blend::add;
    r.play("drag \"Canvas\":@40,180 \"Canvas\":@40,0 6\nframes 30");
    CHECK(r.value(1, 40, 180) == 0);
    CHECK(r.value(1, 40, 0) == doctest::Approx(1).epsilon(0.01));
    r.play("click \"Combine carried\"\nframes 3\nclick \"Combine carried Replace\"\nframes 30");
    CHECK(r.pending());
    CHECK(r.value(1, 40, 0) == doctest::Approx(0.5).epsilon(0.01));
    r.play("key Enter\nframes 3");
    CHECK(r.selected(40, 0) > 0.99);
    CHECK(r.selected(40, 180) < 0.01);
    r.play("key Ctrl+Z\nframes 3");
    CHECK(r.document().design == both);
}

TEST_CASE("transform: of a mask") {
    TransformRig r;
    r.play(
        "key 1\nclick \"Paint the mask\"\nkey E\nframes 30\nclick \"Canvas\":@30,0\nframes 30\nkey W\nframes "
        "30\n"
        "drag \"Canvas\":0.15,0.35 \"Canvas\":0.45,0.65 4\nframes 30\nkey C\nframes 3");
    REQUIRE(r.selected(30, 0) > 0.99);
    CHECK(r.value(0, 30, 0, LayerPart::mask) == 0);
    r.play("drag \"Canvas\":@30,0 \"Canvas\":@30,180 6\nframes 3\nkey Enter\nframes 3");
    CHECK(r.value(0, 30, 180, LayerPart::mask) < 0.02);
    CHECK(r.layers()[0].lobe == r.painted.distribution.layers[0].lobe);
}

TEST_CASE(
    "transform: Ctrl+Z takes back a first one too; another layer leaves it applied, with what was selected") {
    TransformRig r;
    r.document() = Document(r.painted);
    r.play("frames 3\nkey Ctrl+A\nframes 3\nkey Ctrl+Shift+A\nframes 3");
    r.play("drag \"Canvas\":@40,0 \"Canvas\":@40,180 6\nframes 30\nkey Ctrl+Z\nframes 3");
    CHECK(r.document().design == r.painted);
    r.play("key W\nframes 30\ndrag \"Canvas\":0.1,0.3 \"Canvas\":0.48,0.7 4\nframes 30\nkey C\nframes 3");
    REQUIRE(r.selected(40, 0) > 0.99);
    r.play("drag \"Canvas\":@40,0 \"Canvas\":@40,180 6\nframes 30\nkey 1\nframes 3");
    CHECK(!r.pending());
    CHECK(r.selected(40, 180) > 0.99);
    CHECK(r.value(1, 40, 180) > 0.9);
}
