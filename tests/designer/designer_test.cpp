// The whole designer, driven as by hand on a window that nobody sees.
#include "app/designer/designer.h"

#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>

#include "app/designer/preview_mouse.h"
#include "app/headless/offscreen_context.h"
#include "app/preview/preview.h"
#include "core/base/error.h"
#include "core/design/design_file.h"
#include "tests/core/temporary_folder.h"
#include "tests/designer/rig.h"

using namespace nacre;
namespace fs = std::filesystem;

namespace {

struct Rig : test::Rig {
    const GaussianLobe& gaussian() { return std::get<GaussianLobe>(layers()[0].lobe); }
};

}  // namespace

TEST_CASE("designer: a drag is one step of undo, and undo and redo are exact") {
    Rig r;
    const Design before = r.document().design;
    r.play("drag \"Width x\":0.5 \"Width x\":0.8 20");
    const Design after = r.document().design;
    CHECK(after != before);
    CHECK(r.document().unsaved());
    r.play("key Ctrl+Z");
    CHECK(r.document().design == before);
    CHECK(!r.document().history.can_undo());
    CHECK(!r.document().unsaved());
    r.play("key Ctrl+Shift+Z");
    CHECK(r.document().design == after);
    r.play("key Ctrl+Z\nkey Ctrl+Y");
    CHECK(r.document().design == after);
}

TEST_CASE("designer: undo while a slider is held waits for the release") {
    Rig r;
    r.play("move \"Width x\":0.5\ndown left\nmove \"Width x\":0.7\nkey Ctrl+Z");
    CHECK(!r.document().history.can_undo());
    r.play("up left\nframes 2");
    CHECK(r.document().history.can_undo());
}

TEST_CASE("designer: typed text is one step, and Ctrl+Z in the field is the field's") {
    Rig r;
    r.play("click \"Material\"\nclick \"Design name\"\ntext \"Brushed\"\nkey Enter\nframes 2");
    CHECK(r.document().design.name == "Brushed");
    r.play("key Ctrl+Z");
    CHECK(r.document().design.name.empty());
}

TEST_CASE("designer: every edit brings new tables") {
    Rig r;
    r.play("wait");
    CHECK(r.stage.designer().preview.has_picture());
    const auto first = r.designer().frame.tables;
    CHECK(first->quality == Quality::final);
    r.play("drag \"Width x\":0.5 \"Width x\":0.1 5\nwait");
    CHECK(r.designer().frame.tables != first);
    CHECK(r.designer().frame.tables->quality == Quality::final);
    CHECK(r.stage.designer().baker.problem().empty());
}

TEST_CASE("designer: a refused design says why, and a good one ends that") {
    Rig r;
    r.play("click \"Layer 1 enabled\"\nwait");
    CHECK(!r.stage.designer().baker.problem().empty());
    r.play("click \"Layer 1 enabled\"\nwait");
    CHECK(r.stage.designer().baker.problem().empty());
}

TEST_CASE("designer: the mouse on the preview moves light and camera") {
    Rig r;
    r.play("wait\ndrag \"Preview\":0.5,0.5 \"Preview\":0.6,0.4 5");
    const Scene lit = r.stage.designer().scene;
    CHECK(lit.light.theta > 5);
    CHECK(lit.light.phi == doctest::Approx(45).epsilon(0.3));
    r.play("move \"Preview\"\ndown right\nmove \"Preview\":0.7,0.5\nup right\nwheel 3");
    CHECK(r.stage.designer().scene.yaw != 0);
    CHECK(r.stage.designer().scene.zoom > 1.2);
    CHECK(!r.document().unsaved());
}

TEST_CASE("preview mouse: a mirror's highlight lies under the pointer") {
    const auto context = make_offscreen_context({16, 16});
    Preview preview;
    Scene scene;
    const SurfaceImage& surface = preview.surface(scene, {800, 600});
    for (const glm::dvec2 pixel :
         {glm::dvec2(400.5, 300.5), {430.5, 280.5}, {300.5, 350.5}, {400.5, 200.5}}) {
        move_light_to(scene, surface, pixel);
        const double theta = scene.light.theta / 2 * 3.14159265358979 / 180;
        const double phi = scene.light.phi * 3.14159265358979 / 180;
        const glm::dvec3 half(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                              std::cos(theta));
        // The sphere's normal is its point.
        const glm::dvec2 at = (pixel - glm::dvec2(400, 300)) / pixels_per_unit(scene, surface.size());
        CHECK(glm::length(half - glm::dvec3(at.x, -at.y, std::sqrt(1 - glm::dot(at, at)))) < 1e-6);
    }
    move_light_to(scene, surface, {799, 1});
    CHECK(scene.light.theta <= 164);
    CHECK(scene.light.phi == doctest::Approx(std::atan2(299, 399) * 180 / 3.14159265358979).epsilon(0.05));
}

TEST_CASE("designer: save as, overwrite question, open") {
    const test::TemporaryFolder folder;
    Rig r;
    const std::string file = (folder / "mine").string();
    r.play("drag \"Width x\":0.5 \"Width x\":0.3 5\nkey Ctrl+S\nframes 5\nkey Ctrl+A\ntext \"" + file +
           "\"\nkey Enter\nframes 5");
    REQUIRE(fs::exists(file + ".nacre"));
    CHECK(load_design(file + ".nacre") == r.document().design);
    CHECK(!r.document().unsaved());
    CHECK(r.document().file == file + ".nacre");

    const Design saved = r.document().design;
    r.play(
        "drag \"Width y\":0.5 \"Width y\":0.6 5\nkey Ctrl+Shift+S\nframes 5\nkey Ctrl+A\ntext "
        "\"mine.nacre\"\nkey Enter\nframes 5");
    CHECK(load_design(file + ".nacre") == r.document().design);  // its own file: no question
    CHECK(load_design(file + ".nacre") != saved);

    std::ofstream(folder / "other.nacre") << "{\"nacre\": 1}";
    r.play(
        "key Ctrl+Shift+S\nframes 5\nkey Ctrl+A\ntext \"other\"\nkey Enter\nframes 5\nclick "
        "\"Cancel\"\nframes 5\nkey Escape\nframes 3");
    CHECK(load_design(folder / "other.nacre") == Design{});
    r.play(
        "key Ctrl+Shift+S\nframes 5\nkey Ctrl+A\ntext \"other\"\nkey Enter\nframes 5\nclick "
        "\"Overwrite\"\nframes 5");
    CHECK(load_design(folder / "other.nacre") == r.document().design);

    r.play("key Ctrl+O\nframes 5\ntext \"mine.nacre\"\nkey Enter\nframes 5");
    CHECK(r.document().file == file + ".nacre");
}

TEST_CASE("designer: unsaved work is not lost without a question") {
    Rig r;
    r.play("drag \"Width x\":0.5 \"Width x\":0.3 5");
    const Design edited = r.document().design;
    r.play("key Ctrl+N\nframes 5\nclick \"Cancel\"\nframes 5");
    CHECK(r.document().design == edited);
    r.play("key Ctrl+Q\nframes 5\nkey Escape\nframes 5");
    CHECK(!r.stage.designer().files.may_quit());
    r.play("key Ctrl+N\nframes 5\nclick \"Discard\"\nframes 5");
    CHECK(r.document().design == starter_design());
    r.play("key Ctrl+Q\nframes 5");
    CHECK(r.stage.designer().files.may_quit());
}

TEST_CASE("designer: a file that cannot be read is told, and the work stays") {
    const test::TemporaryFolder folder;
    std::ofstream(folder / "broken.nacre") << "{\"nacre\": 1,";
    Rig r;
    const Design before = r.document().design;
    r.play("key Ctrl+O\nframes 5\ntext \"" + (folder / "broken.nacre").string() + "\"\nkey Enter\nframes 5");
    CHECK(r.stage.designer().files.talking());
    r.play("key Enter\nframes 5");
    CHECK(!r.stage.designer().files.talking());
    CHECK(r.document().design == before);
}

TEST_CASE("stage: an unknown widget is an error at its line") {
    Rig r;
    CHECK_THROWS_WITH_AS(r.play("wait\nclick \"No such thing\""),
                         "test: line 2: no widget of this name is on the screen (No such thing)", UserError);
}

TEST_CASE("stage: the picture has the window's size and is not empty") {
    Rig r;
    r.play("wait");
    r.stage.frame();
    const auto pixels = r.stage.pixels();
    CHECK(pixels.size() == std::size_t{1280} * 800 * 4);
    CHECK(std::any_of(pixels.begin(), pixels.end(),
                      [](std::uint8_t byte) { return byte > 200 && byte < 255; }));
}

TEST_CASE("designer: a carried layer is one step of undo, its new name another") {
    Rig r;
    r.play("click \"Add layer\"\nclick \"Add GGX\"\nclick \"Add layer\"\nclick \"Add Uniform\"");
    const auto before = r.document().design;
    r.play("frames 30\ndrag \"Layer 1\" \"Layer 3\":0.5,0.9");
    const auto moved = r.document().design;
    CHECK(std::holds_alternative<GaussianLobe>(r.layers()[2].lobe));
    r.play("frames 30\nclick \"Layer 3\"\nclick \"Layer 3\"\nframes 3\ntext \"Core\"\nkey Enter\nframes 2");
    CHECK(r.layers()[2].name == "Core");
    r.play("key Ctrl+Z");
    CHECK(r.document().design == moved);
    r.play("key Ctrl+Z");
    CHECK(r.document().design == before);
    r.play("key Ctrl+Y\nkey Ctrl+Y");
    CHECK(r.layers()[2].name == "Core");
}
