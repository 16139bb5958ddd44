// Painting on the canvas, as by hand.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "core/design/design_file.h"
#include "core/paint/painted_layer.h"
#include "core/paint/raster_texels.h"
#include "tests/designer/rig.h"

using namespace nacre;

namespace {

struct Rig : test::Rig {
    const Raster& raster(std::size_t layer) {
        return *std::get<PaintedLobe>(layers().at(layer).lobe).image.raster;
    }
    double value(std::size_t layer, double theta, double phi) {
        constexpr double radians = std::numbers::pi / 180;
        const double sine = std::sin(theta * radians);
        const dvec3 h(sine * std::cos(phi * radians), sine * std::sin(phi * radians),
                      std::cos(theta * radians));
        return raster_value(raster(layer).values, raster(layer).width, disk_point(h));
    }
};

}  // namespace

TEST_CASE(
    "paint: a stroke on a lobe begins a painted layer, in one step of undo, back and forth to the bit") {
    Rig r;
    const Design before = r.document().design;
    r.play("click \"Paint\"\ndrag \"Canvas\":@40,0 \"Canvas\":@40,90 15");
    REQUIRE(r.layers().size() == 2);
    CHECK(r.stage.designer().layers.chosen == 1);
    CHECK(r.layers()[1].enabled);
    CHECK(r.layers()[0] == before.distribution.layers[0]);
    CHECK(r.value(1, 40, 0) > 0.5);
    CHECK(r.value(1, 40, 90) > 0.5);
    CHECK(r.value(1, 60, 45) == 0);
    const Design painted = r.document().design;
    r.play("wait");
    CHECK(r.stage.designer().baker.problem().empty());
    r.play("key Ctrl+Z");
    CHECK(r.document().design == before);
    CHECK(!r.document().history.can_undo());
    r.play("key Ctrl+Y");
    CHECK(r.document().design == painted);
    CHECK(parse_design(design_json(painted, "."), "test", ".") == painted);
}

TEST_CASE("paint: a second stroke stays on the layer and is a step of its own") {
    Rig r;
    r.play("click \"Paint\"\ndrag \"Canvas\":@40,0 \"Canvas\":@40,20 5");
    const Design first = r.document().design;
    r.play("drag \"Canvas\":@60,200 \"Canvas\":@60,220 5");
    CHECK(r.layers().size() == 2);
    CHECK(r.value(1, 60, 210) > 0.5);
    CHECK(r.layers()[1].weight > first.distribution.layers[1].weight);
    r.play("key Ctrl+Z");
    CHECK(r.document().design == first);
}

TEST_CASE("paint: few events or many draw the same stroke") {
    const auto drawn = [](const std::string& frames) {
        Rig r;
        r.play("click \"Paint\"\ndrag \"Canvas\":@50,10 \"Canvas\":@50,200 " + frames);
        return r.raster(1);
    };
    const Raster few = drawn("1"), many = drawn("60");
    double worst = 0;
    for (std::size_t i = 0; i < few.values.size(); ++i)
        worst = std::max(worst, std::abs(static_cast<double>(few.values[i] - many.values[i])));
    // Each event stands on a whole pixel, so that the ways lie up to one apart; on the brush's soft edge that
    // is as much as this.
    CHECK(worst < 0.15);
    CHECK(raster_mass(few) == doctest::Approx(raster_mass(many)).epsilon(0.005));
}

TEST_CASE("paint: what is erased leaves the design valid, and its layer out") {
    Rig r;
    r.play("click \"New painted layer\"");
    CHECK(!r.layers().at(1).enabled);
    CHECK(r.canvas().tool == ui::CanvasTool::paint);
    r.play("click \"Canvas\":@30,30\nwait");
    CHECK(r.layers()[1].enabled);
    r.canvas().brush = {.radius = 20, .hardness = 0.9, .flow = 1};
    r.play("click \"Erase\"\nframes 30\nclick \"Canvas\":@30,30\nwait");
    CHECK(raster_mass(r.raster(1)) == 0);
    CHECK(!r.layers()[1].enabled);
    CHECK(r.stage.designer().baker.problem().empty());
    CHECK_NOTHROW(parse_design(design_json(r.document().design, "."), "test", "."));
}

TEST_CASE("paint: keys choose tools and the brush's radius, unless a text is typed") {
    Rig r;
    r.play("key B");
    CHECK(r.canvas().tool == ui::CanvasTool::paint);
    const double radius = r.canvas().brush.radius;
    r.play("key ]");
    CHECK(r.canvas().brush.radius == doctest::Approx(1.15 * radius));
    r.play("key [\nkey [");
    CHECK(r.canvas().brush.radius == doctest::Approx(radius / 1.15));
    r.play("click \"Layer name\"\nkey E\nkey ]");
    CHECK(r.canvas().tool == ui::CanvasTool::paint);
    CHECK(r.canvas().brush.radius == doctest::Approx(radius / 1.15));
}

TEST_CASE("paint: shapes are drawn anew until the button is released") {
    Rig r;
    r.play("click \"Ring\"\nmove \"Canvas\":@0,0\ndown left\nmove \"Canvas\":@60,0\nmove \"Canvas\":@30,0");
    CHECK(r.value(1, 30, 200) > 0.4);
    CHECK(r.value(1, 60, 200) == 0);
    r.play("up left\nkey Ctrl+Z");
    CHECK(r.layers().size() == 1);
    r.play(
        "click \"Symmetry\"\nclick \"Symmetry Mirror x\"\nclick \"Line\"\ndrag \"Canvas\":@20,0 "
        "\"Canvas\":@70,0");
    CHECK(r.value(1, 45, 0) > 0.4);
    CHECK(r.value(1, 45, 180) == r.value(1, 45, 0));
}

TEST_CASE("paint: on a layer that leans the brush lands under the pointer") {
    Rig r;
    r.play("click \"New painted layer\"");
    r.layers()[1].tilt = 35;
    r.layers()[1].azimuth = 80;
    r.play("click \"Canvas\":@35,80\nwait");
    CHECK(r.value(1, 0, 0) > 0.4);
    CHECK(r.layers()[1].tilt == 35);
}
