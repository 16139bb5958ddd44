// Every widget says what it does for the look.
#include <doctest/doctest.h>
#include <imgui_internal.h>

#include <algorithm>
#include <set>

#include "tests/designer/rig.h"
#include "ui/canvas_tools.h"

using namespace nacre;
using nacre::test::Rig;

namespace {

// Their own text or place says it all: menus, tabs, the two pictures; a curve and a plot read out what is
// pointed at.
bool speaks_for_itself(const std::string& name) {
    if (name.starts_with("Curve point")) return true;
    static const std::set<std::string> names = {"File",   "Edit",     "Select", "View",    "Help",
                                                "Layers", "Material", "Light",  "Compare", "Presets",
                                                "Canvas", "Preview",  "Curve",  "Plot"};
    return names.contains(name);
}

// What of a text the font does not have.
std::string without_glyphs(const std::string& text) {
    std::string missing;
    unsigned int letter = 0;
    for (const char* at = text.c_str(); *at != 0;) {
        const int bytes = ImTextCharFromUtf8(&letter, at, nullptr);
        if (letter >= ' ' && ImGui::GetFont()->FindGlyphNoFallback(static_cast<ImWchar>(letter)) == nullptr)
            missing.append(at, static_cast<std::size_t>(bytes));
        at += bytes;
    }
    return missing;
}

// Rests the pointer on each widget that is shown; `told` are those that were asked before.
void check_all_explained(Rig& r, std::set<std::string>& told) {
    r.play("frames 2");
    for (const std::string& name : r.stage.items().names()) {
        if (speaks_for_itself(name) || told.contains(name)) continue;
        r.play("move \"" + name + "\"\nframes 30");
        CAPTURE(name);
        CHECK(r.stage.items().tooltip().size() > 10);
        CHECK(without_glyphs(r.stage.items().tooltip()) == "");
        told.insert(name);
    }
}

}  // namespace

TEST_CASE("tooltips: each widget of each panel explains itself") {
    Rig r;
    std::set<std::string> told;
    r.play("wait");
    for (const char* panel : {"Layers", "Material", "Light", "Compare"}) {
        r.play(std::string("click \"") + panel + "\"");
        check_all_explained(r, told);
    }
}

TEST_CASE("tooltips: what a choice brings") {
    Rig r;
    std::set<std::string> told;
    r.play("wait\nclick \"Light\"\nclick \"Second light\"\nclick \"Rim light\"\nclick \"Ambient light\"");
    check_all_explained(r, told);
    r.play("click \"Plots\"\nframes 5");
    check_all_explained(r, told);
    r.play("click \"Compare\"\nclick \"View Difference\"\nclick \"Take snapshot\"\nwait");
    check_all_explained(r, told);
    r.play("key Ctrl+D\nkey Ctrl+D\nkey Ctrl+Z\nkey Ctrl+H\nframes 30");
    REQUIRE(r.stage.items().rectangle("Step 2"));
    check_all_explained(r, told);
}

TEST_CASE("tooltips: each kind of lobe") {
    Rig r;
    std::set<std::string> told;
    for (const char* kind : KindSet<Lobe>::labels) {
        r.play("click \"Add layer\"\nclick \"Add " + std::string(kind) + "\"");
        check_all_explained(r, told);
    }
}

TEST_CASE("tooltips: each tool") {
    Rig r;
    std::set<std::string> told;
    for (const ui::ToolEntry& tool : ui::canvas_tools()) {
        r.play(std::string("move \"Canvas\"\nkey ") + tool.face->key);
        check_all_explained(r, told);
    }
}
