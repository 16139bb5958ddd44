// What a user called something is shown whole, whatever it means to Dear ImGui.
#include <doctest/doctest.h>
#include <imgui_internal.h>

#include <string>

#include "core/design/design.h"
#include "tests/ui/panel_rig.h"
#include "ui/canvas_toolbar.h"
#include "ui/compare_panel.h"
#include "ui/dialogs.h"
#include "ui/layers_panel.h"
#include "ui/presets_panel.h"

using namespace nacre;

namespace {

// Each with a plain text of as many letters that can be seen.
struct Name {
    const char* odd;
    const char* plain;
};
constexpr Name names[] = {{"x##y", "xxxx"}, {"a###b", "aaaaa"}, {"##", "xx"},    {"y#", "yy"},
                          {"%s", "xx"},     {"100%", "xxxx"},   {"%n%d", "xxxx"}};

int vertices_drawn() { return ImGui::GetDrawData()->TotalVtxCount; }

// What is drawn with each odd name has as many letters as with the plain one: `vertices(name)` draws it.
template <class Vertices>
void check_whole(const Vertices& vertices) {
    for (const Name& name : names) {
        CAPTURE(name.odd);
        CHECK(vertices(name.odd) == vertices(name.plain));
    }
    CHECK(vertices("xx") < vertices("xxxx"));
}

}  // namespace

TEST_CASE("labels: Dear ImGui hides no part of one, and it is found as it was written") {
    for (const Name& name : names) {
        CAPTURE(name.odd);
        const std::string label = ui::as_label(name.odd) + "##hidden";
        const char* const end = ImGui::FindRenderedTextEnd(label.c_str());
        CHECK(std::string(label.c_str(), end) == ui::as_label(name.odd));
        PanelRig rig([&] {
            ImGui::Button(ui::as_label(name.odd).c_str());
            ui::note_item(ui::as_label(name.odd));
        });
        CHECK(rig.has(name.odd));
    }
    CHECK(ui::as_label("caf\xc3\xa9 1") == "caf\xc3\xa9 1");
    CHECK(ui::as_label("a\xff") == "a\xef\xbf\xbd");
}

TEST_CASE("labels: names of layers, in the list, carried and as a field") {
    check_whole([](const char* name) {
        Distribution distribution;
        distribution.layers = {Layer{}, Layer{}};
        distribution.layers[0].name = name;
        ui::LayersView view;
        view.chosen = 1;
        bool paints_mask = false;
        PanelRig rig([&] { ui::layers_panel(view, distribution, paints_mask); });
        rig.move("Layer 1");
        rig.button(true);
        rig.move("Layer 2");
        rig.frame(2);
        const int carried = vertices_drawn();
        rig.button(false);
        return carried;
    });
}

TEST_CASE("labels: files and folders in Nacre's browser, and what it says") {
    check_whole([](const char* name) {
        ui::FileDialog dialog;
        dialog.title = "Open";
        dialog.listing.directory = std::string("/") + name;
        dialog.listing.entries = {{name, true}, {name + std::string(".nacre"), false}};
        dialog.problem = name;
        std::filesystem::path chosen;
        PanelRig rig([&] {
            ui::file_dialog(
                dialog, [&](const auto&) { return dialog.listing; }, chosen);
        });
        rig.frame(3);
        return vertices_drawn();
    });
}

TEST_CASE("labels: snapshots as sides of a comparison") {
    check_whole([](const char* name) {
        ui::CompareState state;
        std::string own = "own";
        const std::vector<ui::SnapshotRow> rows = {{.letter = "A", .name = &own}};
        const std::vector<ui::SideChoice> choices = {{state.left, name, "", true},
                                                     {state.left + 7, name, "", true}};
        PanelRig rig([&] { ui::compare_panel(state, rows, choices, name); });
        rig.click("Left");
        rig.move("Take snapshot");
        rig.frame(2);
        return vertices_drawn();
    });
}

TEST_CASE("labels: stamps of a user") {
    check_whole([](const char* name) {
        ui::CanvasState state;
        state.tool = ui::CanvasTool::stamp;
        state.stamps.push_back(named_stamp(name, state.stamps.front().picture));
        state.stamp = state.stamps.size() - 1;
        Distribution distribution;
        std::size_t chosen = 0;
        PanelRig rig([&] { ui::canvas_toolbar(state, {}, distribution, chosen); });
        rig.click("Stamp picture");
        rig.move("Brush radius");
        rig.frame(2);
        return vertices_drawn();
    });
}

TEST_CASE("labels: presets of a user, and questions") {
    check_whole([](const char* name) {
        const std::vector<ui::PresetTile> tiles = {{name, nullptr}};
        PanelRig rig([&] {
            ui::presets_panel(tiles, std::nullopt);
            ui::question("Overwrite?", std::string(name) + " exists already.", {"Overwrite", "Cancel"});
        });
        CHECK(rig.has(std::string("Preset ") + name));
        return vertices_drawn();
    });
}
