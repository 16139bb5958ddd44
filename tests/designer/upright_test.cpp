// What is painted or stamped shines the way it was: up is up, left is left.
#include <doctest/doctest.h>

#include <cmath>
#include <fstream>
#include <numbers>

#include "app/designer/lit_picture.h"
#include "tests/designer/folder_rig.h"
#include "tests/designer/highlight_rig.h"

using namespace nacre;

namespace {

// With nothing but what is painted.
struct Rig : test::HighlightRig {
    Rig() {
        play("click \"Layer 1 enabled\"");
        document().design.diffuse = NoDiffuse{};
        document().commit();
        canvas().brush = {.radius = 40, .hardness = 0.9, .flow = 1};
    }
};

// Eyes above, mouth below, nothing where they would be upside down. Degrees from the middle.
void check_upright(const Rig& r) {
    const double lit = 0.1, dark = 0.01;
    CHECK(r.shines(-12.8, 11.2) > lit);
    CHECK(r.shines(12.8, 11.2) > lit);
    CHECK(r.shines(0, -20) > lit);
    CHECK(r.shines(0, 20) < dark);
    CHECK(r.shines(0, 0) < dark);
    CHECK(r.shines(-10, -8) < dark);
}

}  // namespace

TEST_CASE("upright: a smiley that is stamped on the canvas, as highlight, as facets or on the dome") {
    for (const char* view : {"", "click \"Seen as\"\n", "click \"Dome\"\n"}) {
        CAPTURE(view);
        Rig r;
        r.play(std::string(view) + "click \"Stamp\"\nclick \"Canvas\":@0,0");
        r.look();
        check_upright(r);
    }
}

TEST_CASE("upright: a smiley that is stamped on the object") {
    Rig r;
    r.play("wait\nclick \"Stamp\"\nclick \"Preview\":0.5,0.5");
    r.look();
    check_upright(r);
}

TEST_CASE("upright: a smiley that is stamped on a layer that is turned") {
    Rig r;
    r.play("click \"New painted layer\"");
    r.layers()[1].rotation = 130;
    r.document().commit();
    r.play("click \"Stamp\"\nclick \"Canvas\":@0,0");
    r.look();
    check_upright(r);
}

TEST_CASE("upright: an angle turns the stamp counterclockwise as it shines, a flip mirrors it") {
    Rig r;
    r.canvas().pose = {.angle = 90, .flip = false};
    r.play("click \"Stamp\"\nclick \"Canvas\":@0,0");
    r.look();
    CHECK(r.shines(20, 0) > 0.1);  // the mouth
    CHECK(r.shines(-20, 0) < 0.01);
    CHECK(r.shines(-11.2, 12.8) > 0.1);
}

TEST_CASE("upright: what is painted at the canvas's top shines at the top, at its left shines left") {
    Rig r;
    r.canvas().brush.radius = 6;
    r.play("click \"Paint\"\nclick \"Canvas\":0.5,0.3\nframes 30");
    r.look();
    const auto& canvas = r.designer().canvas;
    r.play("move \"Canvas\":0.5,0.3\nframes 2");
    REQUIRE(canvas.pointed_at());
    const dvec3 h = *canvas.pointed_at();
    CHECK(h.y < -0.1);
    const double tilt = std::acos(h.z) * 180 / std::numbers::pi;
    CHECK(r.shines(0, tilt) > 0.1);
    CHECK(r.shines(0, -tilt) < 0.01);
    r.play("move \"Canvas\":0.3,0.5\nframes 2");
    REQUIRE(canvas.pointed_at());
    CHECK(canvas.pointed_at()->x > 0.1);
    r.play("click \"Seen as\"\nmove \"Canvas\":0.3,0.5\nframes 2");
    REQUIRE(canvas.pointed_at());
    CHECK(canvas.pointed_at()->x < -0.1);
}

TEST_CASE("upright: the tab of the palette chooses a stamp, and a file becomes one") {
    test::FolderRig r;
    // A black bar at the left on a white ground: the dark paints.
    std::ofstream(r.folder / "logo.pgm")
        << "P2 5 5 255\n255 255 255 255 255 255 0 255 255 255 255 0 255 255 255 "
           "255 0 255 255 255 255 255 255 255 255\n";
    r.play("click \"Stamp\"\nclick \"Stamp picture\"\nclick \"Stamp Star\"");
    CHECK(r.canvas().stamps[r.canvas().stamp].name == "Star");
    r.play("click \"Flip stamp\"");
    CHECK(r.canvas().pose.flip);
    r.designer().stamps.want(r.folder / "logo.pgm");
    r.play("wait\nframes 3");
    const NamedStamp& stamp = r.canvas().stamps[r.canvas().stamp];
    CHECK(stamp.name == "logo");
    CHECK(stamp.picture->values[6] > 0.99f);
    CHECK(stamp.picture->values[0] == 0);
    CHECK(r.designer().files.message() == "logo.pgm: the dark paints, since its edge is white");
    r.designer().stamps.want(r.folder / "none.png");
    r.play("wait\nframes 3");
    CHECK(r.designer().stamps.talking());
}

TEST_CASE("upright: the canvas in the material's colours is the sphere that is lit from the viewer") {
    Rig r;
    r.layers()[0].enabled = true;
    r.layers()[0].tilt = 25;
    r.layers()[0].azimuth = 40;
    r.layers()[0].tint = {0.9, 0.2, 0.1};
    r.layers().push_back(r.layers()[0]);
    r.layers()[1].azimuth = 200;
    r.layers()[1].tint = {0.1, 0.2, 0.9};
    r.document().commit();
    r.look();
    const Scene& scene = r.designer().scene;
    const HemisphereView view({}, {300, 300});
    const HemispherePicture canvas =
        lit_picture(*r.designer().frame.tables, scene.light.irradiance * std::exp2(scene.exposure), view, 1);
    constexpr int side = 400;
    const RenderedImage sphere = r.designer().preview.picture(scene, {side, side}, false);
    const double unit = pixels_per_unit(scene, {side, side});
    int reds = 0, blues = 0;
    for (int row = 5; row < 300; row += 10)
        for (int column = 5; column < 300; column += 10) {
            const dvec3 h = view.nearest_direction({column + 0.5, row + 0.5});
            if (view.coverage({column + 0.5, row + 0.5}) < 1 || h.z < 0.2) continue;
            const auto in_canvas = static_cast<std::size_t>(row * 300 + column) * 4;
            // The sphere's tangents run along its parallels.
            const double parallel = 1 / std::hypot(1, h.y / h.z);
            const glm::dvec2 seen = -parallel * glm::dvec2(h.x, h.y / h.z);
            const glm::ivec2 pixel(0.5 * side + unit * glm::dvec2(seen.x, -seen.y));
            const auto on_sphere = static_cast<std::size_t>(pixel.y * side + pixel.x) * 3;
            for (std::size_t c = 0; c < 3; ++c) {
                CAPTURE(h.x);
                CAPTURE(h.y);
                CHECK(canvas.rgba[in_canvas + c] / 255.0 ==
                      doctest::Approx(sphere.rgb.at(on_sphere + c)).scale(1).epsilon(0.03));
            }
            reds += canvas.rgba[in_canvas] > canvas.rgba[in_canvas + 2] + 60 ? 1 : 0;
            blues += canvas.rgba[in_canvas + 2] > canvas.rgba[in_canvas] + 60 ? 1 : 0;
        }
    CHECK(reds > 3);
    CHECK(blues > 3);
}
