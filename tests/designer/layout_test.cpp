// Borders between the parts of the window, and the scale of all of it.
#include <doctest/doctest.h>
#include <imgui_internal.h>

#include "rig.h"
#include "ui/canvas_tools.h"

namespace {

using nacre::Layout;
using nacre::test::Rig;

ImVec4 box(Rig& rig, const char* widget) {
    const auto found = rig.stage.items().rectangle(widget);
    REQUIRE_MESSAGE(found, widget);
    return *found;
}

float width(Rig& rig, const char* widget) { return box(rig, widget).z - box(rig, widget).x; }

}  // namespace

TEST_CASE("Layout: a border goes where it is dragged, stays there, and goes back by a double click") {
    Rig rig;
    const float canvas = width(rig, "Canvas"), preview = width(rig, "Preview");
    rig.play("drag \"Canvas border\" 900 400\n");
    rig.stage.frame();
    CHECK(box(rig, "Preview").x == doctest::Approx(900).epsilon(0.01));
    CHECK(width(rig, "Canvas") + width(rig, "Preview") == doctest::Approx(canvas + preview));
    const Layout dragged = rig.designer().settings.values.layout;
    CHECK(dragged != Layout());
    rig.play("move 640 300\nframes 5\n");
    CHECK(rig.designer().settings.values.layout == dragged);
    rig.play("click \"Canvas border\"\nclick \"Canvas border\"\nmove 640 300\n");
    rig.stage.frame();
    CHECK(width(rig, "Canvas") == doctest::Approx(canvas).epsilon(0.005));
}

TEST_CASE("Layout: the panel's border moves the panel alone, within bounds") {
    Rig rig;
    const float tab = box(rig, "Layers").x;
    rig.play("drag \"Panel border\" 400 400\n");
    rig.stage.frame();
    CHECK(box(rig, "Canvas").x == doctest::Approx(400).epsilon(0.02));
    CHECK(box(rig, "Layers").x == tab);
    rig.play("drag \"Panel border\" 2 400\n");
    rig.stage.frame();
    CHECK(box(rig, "Canvas").x > 200);
    rig.play("drag \"Panel border\" 1270 400\n");
    rig.stage.frame();
    CHECK(box(rig, "Canvas").x < 0.41f * 1280);
}

TEST_CASE("Layout: the canvas stays where it is, whatever the tool") {
    for (const int width : {1280, 1600, 2560}) {
        Rig rig({width, 800});
        const ImVec4 before = box(rig, "Canvas");
        for (const nacre::ui::ToolEntry& entry : nacre::ui::canvas_tools()) {
            CAPTURE(width);
            CAPTURE(entry.face->name);
            rig.canvas().tool = entry.tool;
            rig.play("frames 2");
            const ImVec4 after = box(rig, "Canvas");
            CHECK(after.y == before.y);
            CHECK(after.w == before.w);
        }
    }
}

TEST_CASE("Layout: the sheet of shortcuts fits a small window") {
    Rig rig({1280, 720});
    rig.play("key F1\nframes 5");
    const ImGuiWindow* sheet = ImGui::FindWindowByName("Shortcuts");
    REQUIRE(sheet != nullptr);
    CHECK(sheet->ScrollMax.x == 0);
    CHECK(sheet->ScrollMax.y == 0);
}

TEST_CASE("Scale: another monitor's makes everything larger by as much, and back again") {
    Rig rig;
    const float size = ImGui::GetFontSize(), height = box(rig, "Layers").w - box(rig, "Layers").y;
    const float canvas = box(rig, "Canvas").x;
    rig.stage.set_scale(1.5f);
    rig.stage.frame();
    rig.stage.frame();
    CHECK(ImGui::GetFontSize() == doctest::Approx(1.5f * size).epsilon(0.03));
    CHECK(box(rig, "Layers").w - box(rig, "Layers").y == doctest::Approx(1.5f * height).epsilon(0.06));
    CHECK(box(rig, "Canvas").x == doctest::Approx(1.5f * canvas).epsilon(0.03));
    const std::vector<std::uint8_t> larger = rig.stage.pixels();
    rig.stage.set_scale(1);
    rig.stage.frame();
    rig.stage.frame();
    CHECK(ImGui::GetFontSize() == size);
    CHECK(box(rig, "Canvas").x == canvas);
    CHECK(rig.stage.pixels() != larger);
}
