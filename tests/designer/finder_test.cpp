// The field that finds what one types.
#include <doctest/doctest.h>

#include "core/design/design_file.h"
#include "tests/designer/rig.h"
#include "ui/command_search.h"

using namespace nacre;

TEST_CASE("find: every word must be there, a name that begins so comes first") {
    const std::vector<ui::SearchEntry> entries = {{"Open recent", "File"},
                                                  {"Rotation", "Layers", "", "turns the lobe"},
                                                  {"Reopen", "File"},
                                                  {"Open", "File", "Ctrl+O"}};
    CHECK(ui::found_entries(entries, "open") == std::vector<std::size_t>{0, 3, 2});
    CHECK(ui::found_entries(entries, "LOBE turn") == std::vector<std::size_t>{1});
    CHECK(ui::found_entries(entries, "") == std::vector<std::size_t>{0, 1, 2, 3});
    CHECK(ui::found_entries(entries, "save").empty());
}

TEST_CASE("find: by keyboard alone a tool is taken, a preset begun, a panel opened, a command done") {
    test::Rig r;
    const Design before = r.document().design;
    r.play("key Ctrl+K\nframes 3\ntext \"smear\"\nframes 2\nkey Enter\nframes 3");
    CHECK(r.canvas().tool == ui::CanvasTool::smear);
    CHECK(!r.designer().search);
    r.play("key F3\nframes 3\ntext \"satin\"\nframes 2\nkey Enter\nframes 3");
    CHECK(r.document().design == load_design(presets_folder() / "satin.nacre"));
    r.play("key Ctrl+K\nframes 3\ntext \"undo\"\nframes 2\nkey Enter\nframes 3");
    CHECK(r.document().design == before);
    r.play("key Ctrl+K\nframes 3\ntext \"exposure\"\nframes 2\nkey Enter\nframes 5");
    CHECK(r.stage.items().rectangle("Environment"));
    r.play("key Ctrl+K\nframes 3\ntext \"e\"\nkey Down\nkey Down\nkey Up\nframes 2");
    REQUIRE(r.designer().search);
    CHECK(r.designer().search->row == 1);
    r.play("key Escape\nframes 3");
    CHECK(!r.designer().search);
    CHECK(r.document().design == before);
}
