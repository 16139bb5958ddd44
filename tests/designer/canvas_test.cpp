// The canvas, used as by hand.
#include <doctest/doctest.h>

#include <cmath>
#include <glm/common.hpp>
#include <string>

#include "core/base/error.h"
#include "core/paint/brush.h"
#include "core/paint/raster_texels.h"
#include "tests/designer/rig.h"
#include "ui/canvas_path.h"
#include "ui/keys.h"

using namespace nacre;

namespace {

struct Rig : test::Rig {
    Layer& layer(std::size_t index) { return layers().at(index); }
};

}  // namespace

TEST_CASE("canvas: wheel and middle button move it, and a double click shows all") {
    Rig r;
    const Design before = r.document().design;
    r.play("move \"Canvas\":0.7,0.4\nwheel 4");
    const HemisphereCamera& camera = r.canvas().camera;
    CHECK(camera.zoom == doctest::Approx(std::pow(1.15, 4)));
    const glm::dvec2 centre = camera.centre;
    r.play("down middle\nmove \"Canvas\":0.8,0.4\nup middle");
    CHECK(camera.centre.x < centre.x - 0.05);
    CHECK(camera.centre.y == doctest::Approx(centre.y));
    r.play("frames 30\nclick \"Canvas\":0.9,0.9\nclick \"Canvas\":0.9,0.9");
    CHECK(camera == HemisphereCamera{});
    r.play("click \"Dome\"\nmove \"Canvas\"\ndown right\nmove \"Canvas\":0.6,0.5\nup right");
    CHECK(camera.dome);
    CHECK(camera.yaw > HemisphereCamera{}.yaw);
    CHECK(r.document().design == before);
}

TEST_CASE("canvas: the axis of a lobe is dragged to where it leans, in one step of undo") {
    Rig r;
    const Design before = r.document().design;
    r.play("drag \"Canvas\":@0,0 \"Canvas\":@40,120 12");
    CHECK(r.layer(0).tilt == doctest::Approx(40).epsilon(0.01));
    CHECK(r.layer(0).azimuth == doctest::Approx(120).epsilon(0.01));
    r.play("key Ctrl+Z");
    CHECK(r.document().design == before);
    CHECK(!r.document().history.can_undo());
}

TEST_CASE("canvas: the ends of a lobe widen it, its outline turns it") {
    Rig r;
    r.layer(0).lobe = GaussianLobe{0.5, 0.2};
    r.document().commit();
    const double degrees = 180 / 3.14159265358979;
    const auto place = [](double theta, double phi) {
        return "\"Canvas\":@" + std::to_string(theta) + "," + std::to_string(phi);
    };
    r.play("drag " + place(std::atan(0.5) * degrees, 0) + " " + place(45, 0));
    CHECK(std::get<GaussianLobe>(r.layer(0).lobe).sigma_x == doctest::Approx(1).epsilon(0.02));
    CHECK(std::get<GaussianLobe>(r.layer(0).lobe).sigma_y == doctest::Approx(0.4).epsilon(0.02));
    r.play("key Ctrl+Z\nframes 2");
    // With Shift the one alone.
    ui::tell_modifiers(ImGui::GetIO(), false, true, false);
    r.play("drag " + place(std::atan(0.5) * degrees, 0) + " " + place(45, 0));
    CHECK(std::get<GaussianLobe>(r.layer(0).lobe).sigma_x == doctest::Approx(1).epsilon(0.02));
    CHECK(std::get<GaussianLobe>(r.layer(0).lobe).sigma_y == 0.2);
    r.play("frames 30\ndrag " + place(std::atan(0.2) * degrees, 90) + " " +
           place(std::atan(0.4) * degrees, 90));
    ui::tell_modifiers(ImGui::GetIO(), false, false, false);
    const GaussianLobe lobe = std::get<GaussianLobe>(r.layer(0).lobe);
    CHECK(lobe.sigma_y == doctest::Approx(0.4).epsilon(0.02));
    // A point of the outline between two ends.
    const double slope = std::hypot(lobe.sigma_x, lobe.sigma_y) / std::sqrt(2.0);
    const double phi = std::atan2(lobe.sigma_y, lobe.sigma_x) * degrees;
    r.play("frames 30\ndrag " + place(std::atan(slope) * degrees, phi) + " " +
           place(std::atan(slope) * degrees, phi + 30));
    CHECK(r.layer(0).rotation == doctest::Approx(30).epsilon(0.03));
    CHECK(std::get<GaussianLobe>(r.layer(0).lobe) == lobe);
}

TEST_CASE("canvas: the ends of a lobe too narrow to see keep apart from its axis, and widen it") {
    Rig r;
    r.layer(0).lobe = GgxLobe{0.002, 0.002};
    r.document().commit();
    r.play("frames 2\nmove \"Canvas\":@0,0");
    const auto box = r.stage.items().rectangle("Canvas").value();
    const HemisphereView view(r.canvas().camera, {box.z - box.x, box.w - box.y});
    const glm::dvec2 axis = view.pixel({0, 0, 1});
    const auto at = [&](double off) {
        return std::to_string(static_cast<double>(box.x) + axis.x + off) + " " +
               std::to_string(static_cast<double>(box.y) + axis.y);
    };
    r.play("drag " + at(11) + " " + at(33) + " 8");
    const GgxLobe wide = std::get<GgxLobe>(r.layer(0).lobe);
    CHECK(wide.alpha_x == doctest::Approx(0.006).epsilon(0.1));
    CHECK(wide.alpha_y == doctest::Approx(wide.alpha_x));
    CHECK(r.layer(0).tilt == 0);
}

TEST_CASE("canvas: a press on another layer's axis chooses it, a double click puts it upright") {
    Rig r;
    Layer leaning;
    leaning.tilt = 50;
    leaning.azimuth = 30;
    r.document().design.distribution.layers.push_back(leaning);
    r.document().commit();
    CHECK(r.stage.designer().layers.chosen == 0);
    r.play("click \"Canvas\":@50,30");
    CHECK(r.stage.designer().layers.chosen == 1);
    CHECK(r.layer(1) == leaning);
    r.play("frames 30\nclick \"Canvas\":@50,30\nclick \"Canvas\":@50,30");
    CHECK(r.layer(1).tilt == 0);
}

TEST_CASE("canvas: straighten brings the mean normal to n in one step, and then has nothing to do") {
    Rig r;
    r.layer(0).tilt = 30;
    r.document().commit();
    const Design leaning = r.document().design;
    r.play("frames 2\nclick \"Straighten\"\nframes 2");
    CHECK(r.layer(0).tilt < 0.5);
    const Design straight = r.document().design;
    r.play("click \"Straighten\"");
    CHECK(r.document().design == straight);
    r.play("key Ctrl+Z");
    CHECK(r.document().design == leaning);
}

TEST_CASE("canvas: balance brings the mean normal to n in one step, or tells why it cannot") {
    Rig r;
    Layer leaning;
    leaning.tilt = 30;
    leaning.weight = 0.3;
    r.layer(0).lobe = GaussianLobe{0.4, 0.4};
    r.document().design.distribution.layers.push_back(leaning);
    r.document().commit();
    const Design before = r.document().design;
    r.play("frames 2\nclick \"Seen as\"\nclick \"Paint\"\nframes 2\nclick \"Balance\"\nframes 2");
    const dvec3 mean = r.designer().frame.p->mean();
    CHECK(std::hypot(mean.x, mean.y) < 1e-9);
    CHECK(!r.canvas().refusal);
    const Design balanced = r.document().design;
    r.play("click \"Balance\"");
    CHECK(r.document().design == balanced);
    r.play("key Ctrl+Z\nframes 2");
    CHECK(r.document().design == before);
    r.layer(0).lobe = GaussianLobe{0.001, 0.001};
    r.document().commit();
    const Design one_sided = r.document().design;
    r.play("frames 2\nclick \"Balance\"\nframes 2");
    CHECK(r.document().design == one_sided);
    REQUIRE(r.canvas().refusal);
    CHECK(r.canvas().refusal->why ==
          "next to nothing would be left of layer 2; Straighten turns all layers instead");
}

TEST_CASE("canvas: of a painted layer the highlight that is grabbed moves by 20 degrees, the other stays") {
    Rig r;
    r.play("click \"New painted layer\"\nclick \"Canvas\":@30,0\nframes 30\nclick \"Canvas\":@50,150");
    const auto mean_around = [&](double theta, double phi) {
        const Layer& layer = r.layer(1);
        const dvec3 middle = polar_direction(theta, phi);
        const Raster& raster = *std::get<PaintedLobe>(layer.lobe).image.raster;
        dvec3 sum{0};
        visit_texels(raster.width, middle, 0.19, [&](std::size_t index, dvec3 h) {
            if (glm::dot(h, middle) > std::cos(0.19)) sum += static_cast<double>(raster.values[index]) * h;
        });
        return sum;
    };
    const dvec3 before = mean_around(30, 0), other = mean_around(50, 150);
    const double weight = r.layer(1).weight;
    r.play("click \"Grab\"\nframes 30\ndrag \"Canvas\":@30,0 \"Canvas\":@50,0 7");
    const dvec3 after = mean_around(50, 0);
    // Each place of the pointer is a whole pixel, up to a fifth of a degree off.
    CHECK(angle_between(glm::normalize(before), glm::normalize(after)) * 180 / 3.14159265358979 ==
          doctest::Approx(20).epsilon(0.02));
    CHECK(glm::length(after) == doctest::Approx(glm::length(before)).epsilon(2e-3));
    CHECK(mean_around(50, 150) == other);
    CHECK(glm::length(mean_around(30, 0)) < 1e-2 * glm::length(before));
    CHECK(r.layer(1).weight == weight);
    CHECK(r.layer(1).tilt == 0);
    r.play("key Ctrl+Z");
    CHECK(mean_around(30, 0) == before);
}

TEST_CASE("canvas: a layer shown alone is what is shown and baked") {
    Rig r;
    Layer leaning;
    leaning.tilt = 50;
    r.document().design.distribution.layers.push_back(leaning);
    r.document().commit();
    const Design before = r.document().design;
    r.play("click \"Layer 2 solo\"\nwait");
    REQUIRE(r.stage.designer().frame.p);
    CHECK(r.stage.designer().frame.p->lobes().size() == 1);
    CHECK(r.document().design == before);
    CHECK(!r.document().history.can_redo());
    r.play("click \"Layer 2 solo\"\nwait");
    CHECK(r.stage.designer().frame.p->lobes().size() == 2);
}

TEST_CASE("canvas: a place on the hemisphere is the canvas's alone") {
    Rig r;
    CHECK_THROWS_WITH_AS(r.play("move \"Preview\":@30,0"),
                         "test: line 1: only the canvas shows normals (Preview)", UserError);
}

TEST_CASE("canvas: its picture has the framebuffer's pixels, however many a unit of the interface has") {
    for (const float pixels : {1.0f, 2.0f}) {
        CAPTURE(pixels);
        HeadlessDesigner stage(
            {.size = {1000, 700}, .ui_scale = 0.5f, .pixels_a_unit = pixels, .bake_threads = 1});
        stage.designer().canvas.insist_on_best();
        stage.frame();
        stage.play(parse_events("move \"Canvas\":@20,30", "test"));
        const auto box = stage.items().rectangle("Canvas");
        REQUIRE(box);
        CHECK(stage.designer().canvas.picture_size() ==
              glm::ivec2(glm::ceil(pixels * glm::vec2(box->z - box->x, box->w - box->y))));
        // The pointer's place counts in units.
        REQUIRE(stage.designer().canvas.pointed_at());
        CHECK(polar_angle(*stage.designer().canvas.pointed_at()) == doctest::Approx(20).epsilon(0.05));
    }
}
