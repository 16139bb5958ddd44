// The field that finds what one types.
#include "app/designer/finder.h"

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

TEST_CASE("find: every setting that is found is on the screen then, also out of the artist's own few") {
    test::Rig r;
    const auto check_settings = [&] {
        std::size_t settings = 0;
        for (const Finding& finding : findings(r.designer())) {
            if (finding.item.empty()) continue;
            CAPTURE(finding.item);
            r.designer().layers.expert = false;
            r.play("click \"Compare\"\nframes 2");
            finding.act(r.designer());
            r.play("frames 3");
            CHECK(r.stage.items().rectangle(finding.item));
            ++settings;
        }
        return settings;
    };
    CHECK(check_settings() > 18);
    r.document().design = load_design(presets_folder() / "copper.nacre");
    CHECK(check_settings() > 18);
    r.layers()[0].lobe = CurveLobe{};
    r.document().design.fresnel = ConductorFresnel{};
    r.document().design.diffuse = LambertianDiffuse{};
    CHECK(check_settings() > 18);
}
