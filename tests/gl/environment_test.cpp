// Light from all around: the preview's samples against closed forms and against core's integral.
#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <glm/geometric.hpp>

#include "app/headless/offscreen_context.h"
#include "core/bake/bake.h"
#include "core/design/design_file.h"
#include "core/light/procedural.h"
#include "tests/core/designs.h"
#include "tests/gl/environment_error.h"

using namespace nacre;
using namespace nacre::test;
namespace fs = std::filesystem;

namespace {

std::shared_ptr<const Tables> preset(const std::string& name) {
    return bake(load_design(fs::path(NACRE_SOURCE_DIR "/presets") / (name + ".nacre")), {.albedo = true});
}

std::shared_ptr<const Environment> environment(const std::string& name, int width) {
    return make_environment(name, *procedural_environment(name, width));
}

// 1 + the part of a direction along one axis: an eighth of a turn of any mirror image changes it.
std::shared_ptr<const Environment> linear_environment(int axis) {
    LatLong picture{256, 128, {}};
    for (int row = 0; row < picture.height; ++row)
        for (int column = 0; column < picture.width; ++column) {
            const glm::dvec3 d =
                lat_long_direction({(column + 0.5) / picture.width, (row + 0.5) / picture.height});
            picture.radiance.emplace_back(static_cast<float>(1 + d[axis]));
        }
    return make_environment("linear", std::move(picture));
}

}  // namespace

TEST_SUITE_BEGIN("environment");

TEST_CASE("in a furnace every preset sends out its own albedo") {
    const auto context = make_offscreen_context({16, 16});
    const auto furnace = environment("furnace", 64);
    Preview preview;
    const ViewedPoints points(preview, 16, 40);
    REQUIRE(points.pixels.size() >= 40);
    int presets = 0;
    for (const auto& entry : fs::directory_iterator(NACRE_SOURCE_DIR "/presets")) {
        if (entry.path().extension() != ".nacre") continue;
        CAPTURE(entry.path().stem().string());
        const auto tables = bake(load_design(entry.path()), {.albedo = true});
        preview.set(tables);
        std::vector<glm::dvec3> albedo;
        for (const glm::dmat3& frame : points.frames) {
            const dvec3 k(frame[0].z, frame[1].z, frame[2].z);
            albedo.push_back(tables->shading.coated_albedo(tables->shading.direction(k)));
        }
        CHECK(relative_error(accumulated(preview, points, furnace, 256), albedo) < 0.02);
        ++presets;
    }
    CHECK(presets >= 14);
}

TEST_CASE("the picture converges to core's integral") {
    const auto context = make_offscreen_context({16, 16});
    Preview preview;
    const ViewedPoints points(preview, 16, 20);
    for (const std::string name : {"chrome", "smiley"}) {
        CAPTURE(name);
        const auto tables = preset(name);
        preview.set(tables);
        for (const std::string around : {"studio", "sky"}) {
            CAPTURE(around);
            const auto light = environment(around, 256);
            const auto exact = integrals(points, tables, light, 2);
            const double coarse = relative_error(accumulated(preview, points, light, 64), exact);
            const double fine = relative_error(accumulated(preview, points, light, 1024), exact);
            CHECK(fine < 0.01);
            CHECK(fine < 0.5 * coarse);
        }
    }
}

TEST_CASE("a retro-reflective picture converges to core's integral") {
    const auto context = make_offscreen_context({16, 16});
    Preview preview;
    const ViewedPoints points(preview, 16, 20);
    Design narrow = design_of(BeckmannLobe{0.05, 0.1}, 15, 30);
    narrow.retro.weight = 0.6;
    const auto tables = bake(narrow);
    preview.set(tables);
    const auto light = environment("studio", 256);
    const auto exact = integrals(points, tables, light, 2);
    const double coarse = relative_error(accumulated(preview, points, light, 64), exact);
    const double fine = relative_error(accumulated(preview, points, light, 1024), exact);
    CHECK(fine < 0.01);
    CHECK(fine < 0.5 * coarse);
}

TEST_CASE("a coated picture converges to core's integral") {
    const auto context = make_offscreen_context({16, 16});
    Preview preview;
    const ViewedPoints points(preview, 16, 20);
    Design paint = design_of(BeckmannLobe{0.1, 0.3}, 10, 30);
    paint.retro.weight = 0.3;
    paint.coat = ClearCoat{0.1, 1.5, {0.9, 0.6, 0.3}};
    const auto tables = bake(paint);
    preview.set(tables);
    const auto light = environment("studio", 256);
    const auto exact = integrals(points, tables, light, 2);
    const double coarse = relative_error(accumulated(preview, points, light, 64), exact);
    const double fine = relative_error(accumulated(preview, points, light, 4096), exact);
    CHECK(fine < 0.01);
    CHECK(fine < 0.2 * coarse);
}

TEST_CASE("a mirror shows each side of the environment on its own side") {
    const auto context = make_offscreen_context({16, 16});
    Design mirror = design_of(BeckmannLobe{0.01, 0.01});
    mirror.fresnel = NoFresnel{};
    const auto tables = bake(mirror, {});
    Preview preview;
    preview.set(tables);
    const ViewedPoints points(preview, 24, 60);
    for (int axis = 0; axis < 3; ++axis) {
        CAPTURE(axis);
        const auto values = accumulated(preview, points, linear_environment(axis), 64);
        for (std::size_t i = 0; i < values.size(); ++i) {
            const glm::dvec3 n = points.frames[i][2];
            if (n.z < 0.4) continue;
            const glm::dvec3 mirrored = 2 * n.z * n - glm::dvec3(0, 0, 1);
            CHECK(values[i].x == doctest::Approx(1 + mirrored[axis]).epsilon(0.02));
        }
    }
}

TEST_CASE("an environment turns to the right, and its brightness is a factor") {
    const auto context = make_offscreen_context({16, 16});
    Preview preview;
    preview.set(preset("ggx-steel"));
    const ViewedPoints points(preview, 24, 60);
    Scene scene;
    scene.environment.picture = linear_environment(0);
    const auto at_side = [&](bool right) {
        const std::vector<float> texels = preview.picture(scene, {24, 24}, 1, true, 64);
        return texels[static_cast<std::size_t>((12 * 24 + (right ? 18 : 5)) * 4)];
    };
    CHECK(at_side(true) > 1.3f * at_side(false));
    // A quarter turn to the right brings what was behind the object, neither bright nor dark, to the right,
    // and what was bright at the right to the viewer's side.
    scene.environment.rotation = 180;
    CHECK(at_side(false) > 1.3f * at_side(true));
    const float once = at_side(false);
    scene.environment.brightness = 3;
    CHECK(at_side(false) == doctest::Approx(3 * once).epsilon(1e-4));
}

TEST_CASE("a picture grows by parts to the very same picture") {
    const auto context = make_offscreen_context({16, 16});
    Preview preview;
    preview.set(preset("copper"));
    Scene scene;
    scene.environment.picture = environment("studio", 256);
    preview.begin(scene, {40, 40}, 2, 64);
    CHECK(preview.progress() == SampleProgress{0, 64});
    int steps = 0, last = 0;
    while (preview.progress().samples < 64) {
        preview.refine(1e-4);
        CHECK(preview.progress().samples >= last);
        last = preview.progress().samples;
        REQUIRE(++steps < 10000);
    }
    CHECK(steps > 1);
    preview.refine(1);
    CHECK(preview.progress() == SampleProgress{64, 64});
    scene.environment = {};
    preview.draw(scene, {40, 40}, 2);
    CHECK(preview.progress() == SampleProgress{});
}

TEST_SUITE_END();
