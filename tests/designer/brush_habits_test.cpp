// What hands know from other painting programs.
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "core/model/polar_angles.h"
#include "core/paint/raster_texels.h"
#include "tests/designer/kept_work.h"
#include "ui/keys.h"

using namespace nacre;
using namespace nacre::test;

namespace {

struct PaintRig : Rig {
    double value(dvec3 h) {
        const Raster& raster = *std::get<PaintedLobe>(layers().at(1).lobe).image.raster;
        return raster_value(raster.values, raster.width, disk_point(h));
    }
    double value(double theta, double phi) { return value(polar_direction(theta, phi)); }

    void play_with(bool ctrl, bool shift, bool alt, const std::string& events) {
        ui::tell_modifiers(ImGui::GetIO(), ctrl, shift, alt);
        play(events);
        ui::tell_modifiers(ImGui::GetIO(), false, false, false);
        play("frames 1");
    }
};

}  // namespace

TEST_CASE("brush: Shift and a click draw a line from where the last stroke ended, in one step of undo") {
    PaintRig r;
    r.canvas().brush = {.radius = 4, .hardness = 0.9, .flow = 1};
    r.play("click \"Paint\"\nclick \"Canvas\":@40,0");
    const Design before = r.document().design;
    r.play_with(false, true, false, "frames 30\nclick \"Canvas\":@40,90");
    const dvec3 middle = glm::normalize(polar_direction(40, 0) + polar_direction(40, 90));
    CHECK(r.value(middle) > 0.9);
    CHECK(r.value(40, 90) > 0.9);
    CHECK(r.value(20, 180) == 0);
    r.play_with(false, true, false, "frames 30\nclick \"Canvas\":@40,180");
    CHECK(r.value(glm::normalize(polar_direction(40, 180) + polar_direction(40, 90))) > 0.9);
    r.play("key Ctrl+Z\nkey Ctrl+Z");
    CHECK(r.document().design == before);
}

TEST_CASE("brush: Shift and a drag size it, and paint nothing") {
    PaintRig r;
    r.play("click \"Paint\"");
    const Design before = r.document().design;
    const double radius = r.canvas().brush.radius;
    r.play_with(false, true, false, "drag \"Canvas\":0.5,0.5 \"Canvas\":0.7,0.5 8");
    CHECK(r.canvas().brush.radius > 1.3 * radius);
    r.play_with(false, true, false, "drag \"Canvas\":0.7,0.5 \"Canvas\":0.5,0.5 8");
    CHECK(r.canvas().brush.radius == doctest::Approx(radius));
    CHECK(r.document().design == before);
}

TEST_CASE("brush: Ctrl or Alt and a click pick the value that is there") {
    PaintRig r;
    r.canvas().brush = {.radius = 10, .hardness = 0.9, .flow = 1, .value = 0.35};
    r.play("click \"Paint\"\nclick \"Canvas\":@40,0");
    r.canvas().brush.value = 1;
    const Design before = r.document().design;
    r.play_with(true, false, false, "frames 30\nclick \"Canvas\":@40,0");
    CHECK(r.canvas().brush.value == doctest::Approx(0.35).epsilon(1e-3));
    r.play_with(false, false, true, "frames 30\nclick \"Canvas\":@40,120");
    CHECK(r.canvas().brush.value == 0);
    CHECK(r.document().design == before);
}

TEST_CASE("brush: a steady hand hangs behind and arrives in the end") {
    PaintRig r;
    r.canvas().brush = {.radius = 3, .hardness = 0.9, .flow = 1};
    r.canvas().steadiness = 1000;
    r.play(
        "click \"Paint\"\nmove \"Canvas\":@40,0\ndown left\nmove \"Canvas\":@40,20\nmove \"Canvas\":@40,60");
    CHECK(r.value(40, 60) == 0);
    r.play("up left\nframes 2");
    CHECK(r.value(40, 60) > 0.9);
}

TEST_CASE("brush: the list sets one, and one of one's own is there again after a restart") {
    const TemporaryFolder folder;
    Brush kept;
    {
        Rig r({.bake_threads = 1, .folders = below(folder)});
        r.play("click \"Paint\"\nclick \"Brush settings\"\nframes 2\nclick \"Brush Hard round\"\nframes 2");
        CHECK(r.canvas().brush.hardness == doctest::Approx(0.95));
        r.play("click \"Combine\"\nframes 2\nclick \"Combine Multiply\"\nframes 2");
        CHECK(r.canvas().brush.blend == Blend::multiply);
        r.play("click \"Brush name\"\ntext \"Mine\"\nclick \"Keep brush\"\nframes 2");
        REQUIRE(r.canvas().own_brushes.size() == 1);
        CHECK(r.canvas().own_brushes[0].name == "Mine");
        kept = r.canvas().brush;
        r.play(
            "key Escape\nframes 2\nclick \"Scale\"\nframes 2\nclick \"Scale Linear\"\nframes 2\nclick "
            "\"Torus\"\nwait\nframes 5");
    }
    Rig r({.bake_threads = 1, .folders = below(folder)});
    r.play("wait\nframes 5");
    CHECK(r.canvas().tool == ui::CanvasTool::paint);
    CHECK(r.canvas().brush == kept);
    CHECK(r.canvas().scale == ScaleKind::linear);
    CHECK(r.designer().scene.object.name == "torus");
    REQUIRE(r.canvas().own_brushes.size() == 1);
    CHECK(r.canvas().own_brushes[0].brush == kept);
}

TEST_CASE("brush: Escape takes back a stroke on a layer that is painted, and the sizing of the brush") {
    PaintRig r;
    r.play("click \"Paint\"\nclick \"Canvas\":@40,0\nframes 30");
    const Design before = r.document().design;
    r.play(
        "move \"Canvas\":@20,90\ndown left\nmove \"Canvas\":@50,90\nkey Escape\nframes 2\nup left\nframes 2");
    CHECK(r.document().design == before);
    const double radius = r.canvas().brush.radius;
    r.play_with(false, true, false, "move \"Canvas\":0.5,0.5\ndown left\nmove \"Canvas\":0.7,0.5\nframes 1");
    r.play("key Escape\nframes 2\nup left\nframes 2");
    CHECK(r.canvas().brush.radius == radius);
    CHECK(r.document().design == before);
    // What comes after is a stroke like any other.
    r.play("click \"Canvas\":@60,200");
    CHECK(r.value(60, 200) > 0.3);
}
