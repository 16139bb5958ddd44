// From the sphere to the hemisphere and back.
#include "app/preview/probe.h"

#include "app/headless/offscreen_context.h"
#include "app/preview/preview.h"

#include <doctest/doctest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <string>

#include "core/paint/brush.h"
#include "core/paint/raster_texels.h"
#include "tests/designer/rig.h"
#include "ui/keys.h"

using namespace nacre;

namespace {

struct Rig : test::Rig {
    Rig() : test::Rig(2) {}
    glm::vec4 box(const char* widget) {
        const ImVec4 r = stage.items().rectangle(widget).value();
        return {r.x, r.y, r.z, r.w};
    }
    // At a pixel of the preview.
    std::optional<dvec3> half_vector_at(glm::dvec2 pixel) {
        const glm::vec4 r = box("Preview");
        const Scene& scene = designer().scene;
        return half_vector(scene, designer().preview.surface(scene, {int(r.z - r.x), int(r.w - r.y)}), pixel);
    }
};

}  // namespace

TEST_CASE("probe: under a mirror's highlight the facets are those along n") {
    const auto context = make_offscreen_context({16, 16});
    Preview preview;
    for (const double yaw : {0.0, 70.0}) {
        Scene scene;
        scene.yaw = yaw;
        scene.pitch = 20;
        const glm::ivec2 size(600, 500);
        const glm::dvec3 middle = glm::normalize(light_direction(scene.light) + glm::dvec3(0, 0, 1));
        const double unit = pixels_per_unit(scene, size);
        const glm::dvec2 pixel(300 + unit * middle.x, 250 - unit * middle.y);
        const SurfaceImage& surface = preview.surface(scene, size);
        const auto h = half_vector(scene, surface, pixel);
        REQUIRE(h);
        CHECK(std::hypot(h->x, h->y) < std::sqrt(0.5) / unit / middle.z);  // no further than a pixel's corner
        // To the right of it the normals lean right, so the facets that light it lean left.
        CHECK(half_vector(scene, surface, pixel + glm::dvec2(40, 0))->x < -0.05);
        CHECK(!half_vector(scene, surface, {2, 2}));
        const Glow glow = glow_of(scene, surface, spot({0, 0, 1}, 3));
        const auto alpha = [&](glm::dvec2 at) {
            const glm::ivec2 texel(at / 4.0);
            return int(glow.rgba[static_cast<std::size_t>((texel.y * glow.size.x + texel.x) * 4 + 3)]);
        };
        CHECK(alpha(pixel) > 120);
        CHECK(alpha(pixel + glm::dvec2(60, 0)) == 0);
        CHECK(alpha({2, 2}) == 0);
    }
}

TEST_CASE("probe: a smiley that is stamped shines on the sphere where its facets are lit") {
    Rig r;
    r.play("click \"Layer 1 enabled\"\nclick \"Stamp\"");
    r.designer().document.design.diffuse = NoDiffuse{};
    r.designer().canvas.state.brush.radius = 35;
    r.designer().canvas.state.brush.flow = 1;
    r.play("click \"Canvas\":@0,0\nmove 5 5\nwait");
    REQUIRE(r.designer().baker.problem().empty());
    r.designer().preview.insist_on_best();
    r.stage.frame();
    const auto pixels = r.stage.pixels();
    const glm::vec4 box = r.box("Preview");
    const glm::ivec2 size(int(box.z - box.x), int(box.w - box.y));
    const auto& layers = r.designer().document.design.distribution.layers;
    const Raster& raster = *std::get<PaintedLobe>(layers.at(1).lobe).image.raster;
    double lit = 0, unlit = 0;
    int lit_count = 0, unlit_count = 0;
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
            const auto h = r.half_vector_at({x + 0.5, y + 0.5});
            if (!h || h->z < 0.7) continue;
            const double painted = raster_value(raster.values, raster.width, disk_point(*h));
            const int column = int(box.x) + x, row = int(box.y) + y;
            const double shown = pixels[static_cast<std::size_t>((row * 1280 + column) * 4 + 1)];
            if (painted > 0.9) lit += shown, ++lit_count;
            if (painted == 0) unlit += shown, ++unlit_count;
        }
    REQUIRE(lit_count > 500);
    REQUIRE(unlit_count > 500);
    CHECK(lit / lit_count > 90);
    CHECK(unlit / unlit_count < 8);
    // In the middle of the highlight stands the middle of the face.
    CHECK(raster_value(raster.values, raster.width, {0, 0}) == 0);
}

TEST_CASE("sphere: the brush paints the facets that light what is pointed at, and Shift moves the light") {
    Rig r;
    r.play("wait\nclick \"Paint\"");
    const Scene scene = r.designer().scene;
    r.play("drag \"Preview\":0.45,0.4 \"Preview\":0.6,0.5 12");
    CHECK(r.designer().scene == scene);
    const auto& layers = r.designer().document.design.distribution.layers;
    REQUIRE(layers.size() == 2);
    const Raster& raster = *std::get<PaintedLobe>(layers[1].lobe).image.raster;
    const glm::vec4 box = r.box("Preview");
    const glm::ivec2 size(int(box.z - box.x), int(box.w - box.y));
    for (const double t : {0.0, 0.5, 1.0}) {
        const glm::dvec2 pixel = glm::dvec2(size) * glm::dvec2(0.45 + 0.15 * t, 0.4 + 0.1 * t);
        const auto h = r.half_vector_at(pixel);
        REQUIRE(h);
        CHECK(raster_value(raster.values, raster.width, disk_point(*h)) > 0.4);
    }
    r.play("key Ctrl+Z\nframes 2");
    CHECK(r.designer().document.design.distribution.layers.size() == 1);
    ui::tell_modifiers(ImGui::GetIO(), false, true, false);
    r.play("drag \"Preview\":0.45,0.4 \"Preview\":0.6,0.5 5");
    ui::tell_modifiers(ImGui::GetIO(), false, false, false);
    CHECK(r.designer().scene != scene);
    CHECK(r.designer().document.design.distribution.layers.size() == 1);
}

namespace {

constexpr double radians = 3.14159265358979 / 180;

// Where the highlight is, and where the half vector has gone 20 degrees along a row of pixels.
struct Drag {
    glm::dvec3 begin, end;
};

Drag drag_by_twenty(Rig& r) {
    const Scene scene = r.designer().scene;
    const glm::vec4 box = r.box("Preview");
    const glm::ivec2 size(int(box.z - box.x), int(box.w - box.y));
    const double unit = pixels_per_unit(scene, size);
    const glm::dvec3 there = glm::normalize(light_direction(scene.light) + glm::dvec3(0, 0, 1));
    const glm::dvec2 from(std::round(0.5 * size.x + unit * there.x),
                          std::round(0.5 * size.y - unit * there.y));
    glm::dvec2 to = from;
    const glm::dvec3 begin = *r.half_vector_at(from);
    while (std::acos(glm::dot(*r.half_vector_at(to), begin)) < 20 * radians) to.x += 1;
    const auto place = [&](glm::dvec2 pixel) {
        return std::to_string(pixel.x + static_cast<double>(box.x)) + " " +
               std::to_string(pixel.y + static_cast<double>(box.y));
    };
    r.play("drag " + place(from) + " " + place(to) + " 10");
    CHECK(r.designer().scene == scene);
    return {begin, *r.half_vector_at(to)};
}

}  // namespace

TEST_CASE("sphere: a highlight grabbed and dragged by 20 degrees moves by 20 degrees") {
    Rig r;
    r.play("wait\nclick \"Grab\"");
    drag_by_twenty(r);
    const Layer& layer = r.designer().document.design.distribution.layers[0];
    CHECK(layer.tilt == doctest::Approx(20).epsilon(0.03));
    r.play("key Ctrl+Z\nframes 2");
    CHECK(r.designer().document.design.distribution.layers[0].tilt == 0);
}

TEST_CASE("sphere: a painted highlight grabbed and dragged by 20 degrees moves by 20 degrees") {
    Rig r;
    const auto& layers = r.designer().document.design.distribution.layers;
    r.play("wait\nclick \"New painted layer\"\nclick \"Canvas\":@0,0\nframes 30\nclick \"Canvas\":@60,90");
    const auto raster = [&] { return *std::get<PaintedLobe>(layers[1].lobe).image.raster; };
    const Raster before = raster();
    r.play("click \"Layer 1 enabled\"\nclick \"Grab\"\nframes 30");
    const Drag drag = drag_by_twenty(r);
    const auto value = [](const Raster& of, glm::dvec3 h) {
        return raster_value(of.values, of.width, disk_point(h));
    };
    const Raster after = raster();
    const glm::dmat3 turn = shortest_rotation(drag.begin, drag.end);
    // Read between texels, the picture there is the one that was here.
    for (const double theta : {0.0, 2.0, 4.0, 6.0})
        for (const double phi : {0.0, 90.0, 210.0}) {
            const double sine = std::sin(theta * radians);
            const glm::dvec3 h(sine * std::cos(phi * radians), sine * std::sin(phi * radians),
                               std::cos(theta * radians));
            CHECK(value(after, turn * h) == doctest::Approx(value(before, h)).epsilon(0.03));
        }
    CHECK(value(after, {0, 0, 1}) == 0);
    const glm::dvec3 other(0, std::sin(60 * radians), std::cos(60 * radians));
    CHECK(value(after, other) == value(before, other));
    CHECK(value(before, other) > 0.3);
}

TEST_CASE("probe: what is pointed at on one side is known on the other") {
    Rig r;
    r.play("wait\nmove \"Preview\":0.5,0.5\nframes 2");
    REQUIRE(r.designer().preview.pointed_at());
    const dvec3 h = *r.designer().preview.pointed_at();
    const glm::vec4 box = r.box("Preview");
    const auto expected =
        r.half_vector_at({std::floor((box.z - box.x) / 2), std::floor((box.w - box.y) / 2)});
    CHECK(glm::length(h - *expected) < 0.02);
    r.play("move \"Canvas\":@25,140\nframes 2");
    CHECK(!r.designer().preview.pointed_at());
    REQUIRE(r.designer().canvas.pointed_at());
    CHECK(r.designer().canvas.pointed_at()->z ==
          doctest::Approx(std::cos(25 * 3.14159265 / 180)).epsilon(0.01));
}
