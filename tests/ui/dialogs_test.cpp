#include "ui/dialogs.h"

#include <algorithm>
#include <string>
#include <vector>

#include "tests/ui/panel_rig.h"
#include "tests/ui/some_commands.h"
#include "ui/presets_panel.h"
#include "ui/widgets.h"

using namespace nacre;

namespace {

// Two folders that exist nowhere.
ui::Listing imagined(const std::filesystem::path& folder) {
    if (folder == "/designs")
        return {.directory = folder, .entries = {{"old", true}, {"satin.nacre", false}}, .problem = {}};
    if (folder == "/designs/old") return {.directory = folder, .entries = {}, .problem = {}};
    return {.directory = folder, .entries = {}, .problem = "No such folder"};
}

struct DialogRig {
    explicit DialogRig(ui::FileDialog::Purpose purpose)
        : dialog{.purpose = purpose, .listing = imagined("/designs"), .path = {}, .problem = {}} {}
    ui::FileDialog dialog;
    std::filesystem::path chosen;
    ui::DialogAnswer answer = ui::DialogAnswer::none;
    PanelRig rig{[this] {
        if (answer == ui::DialogAnswer::none) answer = ui::file_dialog(dialog, imagined, chosen);
    }};
};

}  // namespace

TEST_CASE("file dialog: a typed name is a path in the shown folder") {
    DialogRig r(ui::FileDialog::Purpose::save);
    r.rig.frame(3);
    r.rig.type("velvet.nacre");
    r.rig.key(PanelRig::enter);
    CHECK(r.answer == ui::DialogAnswer::accepted);
    CHECK(r.chosen == "/designs/velvet.nacre");
}

TEST_CASE("file dialog: a typed absolute path wins, a typed folder is entered") {
    DialogRig r(ui::FileDialog::Purpose::open);
    r.rig.frame(3);
    r.rig.type("old");
    r.rig.key(PanelRig::enter);
    CHECK(r.answer == ui::DialogAnswer::none);
    CHECK(r.dialog.listing.directory == "/designs/old");
    r.rig.frame(3);
    r.rig.type("/elsewhere/a.nacre");
    r.rig.key(PanelRig::enter);
    CHECK(r.chosen == "/elsewhere/a.nacre");
}

TEST_CASE("file dialog: click and Open, double click, Cancel, Escape") {
    SUBCASE("click and Open") {
        DialogRig r(ui::FileDialog::Purpose::open);
        r.rig.click("satin.nacre");
        CHECK(r.answer == ui::DialogAnswer::none);
        r.rig.click("Accept");
        CHECK(r.chosen == "/designs/satin.nacre");
    }
    SUBCASE("double click") {
        DialogRig r(ui::FileDialog::Purpose::open);
        r.rig.double_click("satin.nacre");
        CHECK(r.answer == ui::DialogAnswer::accepted);
        CHECK(r.chosen == "/designs/satin.nacre");
    }
    SUBCASE("double click on a folder enters it") {
        DialogRig r(ui::FileDialog::Purpose::open);
        r.rig.double_click("old/");
        CHECK(r.answer == ui::DialogAnswer::none);
        CHECK(r.dialog.listing.directory == "/designs/old");
        r.rig.click("Parent folder");
        CHECK(r.dialog.listing.directory == "/designs");
    }
    SUBCASE("Cancel") {
        DialogRig r(ui::FileDialog::Purpose::open);
        r.rig.click("Cancel");
        CHECK(r.answer == ui::DialogAnswer::cancelled);
    }
    SUBCASE("Escape") {
        DialogRig r(ui::FileDialog::Purpose::open);
        r.rig.frame(3);
        r.rig.key(PanelRig::escape);
        CHECK(r.answer == ui::DialogAnswer::cancelled);
    }
}

TEST_CASE("question: buttons, Enter and Escape") {
    std::optional<int> answer;
    PanelRig rig([&] {
        if (!answer) answer = ui::question("Really?", "Think.", {"Save", "Discard", "Cancel"});
    });
    SUBCASE("button") {
        rig.click("Discard");
        CHECK(answer == 1);
    }
    SUBCASE("Enter") {
        rig.key(PanelRig::enter);
        CHECK(answer == 0);
    }
    SUBCASE("Escape") {
        rig.key(PanelRig::escape);
        CHECK(answer == 2);
    }
}

TEST_CASE("shortcuts: each one, its other keys too, and none while text is typed") {
    std::vector<ui::Order> pressed;
    std::string text;
    PanelRig rig([&] {
        if (const auto command = ui::pressed_shortcut(some_commands::infos())) pressed.push_back(*command);
        ImGui::SetNextItemWidth(100);
        char buffer[8] = "";
        ImGui::InputText("##field", buffer, sizeof(buffer));
        ui::note_item("Field");
    });
    rig.key('S', true);
    rig.key('S', true, true);
    rig.key('Z', true);
    rig.key('Z', true, true);
    rig.key('Y', true);
    rig.key('S');
    using namespace some_commands;
    CHECK(pressed == std::vector<ui::Order>{{save}, {undo}, {redo}, {redo}});
    pressed.clear();
    rig.click("Field");
    rig.key('Z', true);
    CHECK(pressed.empty());
}

TEST_CASE("presets: a click returns the index") {
    const std::vector<ui::PresetTile> names = {{"Gold"}, {"Satin"}, {"Velvet"}};
    std::optional<std::size_t> clicked;
    PanelRig rig([&] {
        if (const auto now = ui::presets_panel(names, std::nullopt).begun) clicked = now;
    });
    rig.click("Preset Satin");
    CHECK(clicked == 1);
}

TEST_CASE("question: Enter and Escape in a field of it are the field's") {
    double number = 1;
    std::optional<int> answer;
    PanelRig rig([&] {
        if (!answer)
            answer = ui::question("Really?", "Think.", {"Yes", "No"}, [&] {
                ui::slider({.label = "How much",
                            .low = 0,
                            .high = 10,
                            .least = 0,
                            .most = 10,
                            .reset = 1,
                            .format = "%.2f",
                            .logarithmic = false,
                            .tooltip = nullptr},
                           number);
            });
    });
    rig.enter_number("How much", "7");
    CHECK(number == 7);
    CHECK(!answer);
    SUBCASE("Enter") {
        rig.key(PanelRig::enter);
        CHECK(answer == 0);
    }
    SUBCASE("Escape: first the typed number, then the question") {
        rig.frame(30);
        rig.move("How much");
        rig.hold(true);
        rig.button(true);
        rig.button(false);
        rig.hold();
        rig.type("3");
        rig.key(PanelRig::escape);
        CHECK(number == 7);
        CHECK(!answer);
        rig.key(PanelRig::escape);
        CHECK(answer == 1);
    }
}
