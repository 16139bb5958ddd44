// Everything but free painting by the keyboard alone.
#include <doctest/doctest.h>

#include <set>
#include <string>

#include "core/model/lobes/gaussian.h"
#include "tests/designer/folder_rig.h"

using namespace nacre;

namespace {

const std::set<std::string> for_the_mouse{"Panel border", "Canvas border"};

// Words, what is disabled now, and what holds fields that have names of their own.
const std::set<std::string> not_for_clicks{"Quality",      "Validity", "Baked tables", "Left out",
                                           "Delete layer", "Layer up", "Layer down",   "Balance",
                                           "Straighten",   "f0",       "Albedo",       "Layer tint"};

// With the pointer where it touches nothing.
struct Keys : test::FolderRig {
    Keys() { play("move 1 1"); }

    void press(const std::string& key, int times = 1) {
        for (int i = 0; i < times; ++i) play("key " + key);
    }

    const std::string& at() { return designer().focus.name(); }

    // Down until the focus is on the widget; false where it comes round without.
    bool go_to(const std::string& name) {
        std::set<std::string> seen;
        while (at() != name) {
            press("Down");
            if (at() != name && !seen.insert(at()).second) return false;
        }
        return true;
    }

    // Of the part of the window that has the focus.
    std::set<std::string> all_along() {
        std::set<std::string> seen;
        if (at().empty()) press("Down");
        while (seen.insert(at()).second) press("Down");
        return seen;
    }

    // To the part that has this widget, and to the widget.
    void find(const std::string& name) {
        press("F6");
        for (int part = 0; part < 8 && !go_to(name); ++part) press("F6");
        CAPTURE(name);
        REQUIRE(at() == name);
    }

    void choose(const std::string& menu, const std::string& item) {
        press("F10");
        REQUIRE(go_to(menu));
        press("Enter");
        play("frames 2");
        REQUIRE(go_to(item));
        press("Enter");
        play("frames 3");
    }

    // Of this frame, what has a name and can be clicked on, but for what only the mouse works on.
    std::set<std::string> on_screen() {
        play("frames 1");
        std::set<std::string> names;
        for (const std::string& name : stage.items().names()) names.insert(name);
        return names;
    }
};

}  // namespace

TEST_CASE("focus: each widget of each part is come to, and what has it is on the screen") {
    Keys r;
    r.designer().layers.expert = true;
    for (const char* tab : {"Layers", "Material", "Light", "Compare", "Presets"}) {
        CAPTURE(tab);
        r.find(tab);
        r.press("Enter");
        r.play("frames 2");
        std::set<std::string> reached;
        for (int part = 0; part < 8; ++part) {
            r.press("F6");
            reached.merge(r.all_along());
        }
        for (const std::string& name : r.on_screen()) {
            if (not_for_clicks.contains(name) || for_the_mouse.contains(name)) continue;
            CAPTURE(name);
            CHECK(reached.contains(name));
        }
        // Far down a panel that is scrolled too.
        for (int i = 0; i < 60; ++i) {
            r.press("Down");
            const auto box = r.stage.items().rectangle(r.at());
            REQUIRE(box);
            CAPTURE(r.at());
            CHECK(box->y >= 0);
            CHECK(box->w <= 801);
        }
    }
}

TEST_CASE("focus: a number changes by arrows, a step of undo for each press, and Enter types it") {
    Keys r;
    r.find("Softness");
    const auto width = [&] { return std::get<GaussianLobe>(r.layers()[0].lobe).sigma_x; };
    const double before = width();
    r.press("Right", 3);
    CHECK(width() > 1.1 * before);
    r.press("Shift+Left");
    r.press("Enter");
    r.play("text \"0.25\"");
    r.press("Enter");
    r.play("frames 3");
    CHECK(width() == doctest::Approx(0.25).epsilon(0.02));
    r.press("Ctrl+Z", 5);
    CHECK(width() == doctest::Approx(before));
}

TEST_CASE("focus: menus, lists, a second menu and a dialog without a mouse") {
    Keys r;
    r.choose("View", "Expert");
    r.choose("View", "Expert");
    r.find("Duplicate layer");
    r.press("Enter");
    r.play("frames 3");
    REQUIRE(r.layers().size() == 2);
    r.find("Layer 1");
    r.press("Shift+F10");
    r.play("frames 2");
    REQUIRE(r.go_to("Menu Delete"));
    r.press("Enter");
    r.play("frames 3");
    CHECK(r.layers().size() == 1);
    CHECK(r.at().starts_with("Layer 1"));
    // A list.
    r.find("Scale");
    r.press("Enter");
    r.play("frames 4");
    CHECK(r.at() == "Scale As seen");
    r.press("Down");
    r.press("Enter");
    r.play("frames 4");
    CHECK(r.canvas().scale == ScaleKind::linear);
    CHECK(r.at() == "Scale");
    // The mouse takes the ring away.
    r.play("click \"Preview\":0.5,0.9");
    CHECK(r.at().empty());
    const double yaw = r.designer().scene.yaw;
    r.choose("View", "Camera");
    REQUIRE(r.go_to("Camera 2"));
    r.press("Enter");
    r.play("frames 2");
    CHECK(r.designer().scene.yaw > yaw);
}

TEST_CASE("focus: no key of it does anything to a text that is typed") {
    Keys r;
    r.find("Layer name");
    r.press("Enter");
    r.play("text \"silk\"");
    r.press("Left");
    r.play("text \"x\"");
    r.press("Enter");
    r.play("frames 2");
    CHECK(r.layers()[0].name == "silxk");
}

TEST_CASE("focus: a stamp, a selection, a handle and the light by the keyboard's pointer") {
    Keys r;
    r.press("T");
    r.find("Canvas");
    r.press("Enter");
    r.press("Enter");
    r.play("frames 3");
    REQUIRE(r.layers().size() == 2);
    CHECK(std::holds_alternative<PaintedLobe>(r.layers()[1].lobe));
    r.press("Ctrl+Z");
    CHECK(r.layers().size() == 1);

    r.press("W");
    r.press("Space");
    r.press("Right", 6);
    r.press("Down", 4);
    CHECK(r.canvas().selecting);
    r.press("Space");
    r.play("frames 2");
    REQUIRE(r.canvas().selection);
    const double zoom = r.canvas().camera.zoom;
    r.press("PageUp");
    r.play("frames 2");
    CHECK(r.canvas().camera.zoom > zoom);

    // Escape takes back what is held, and then ends.
    const auto kept = r.canvas().selection;
    r.press("Space");
    r.press("Left", 5);
    r.press("Escape");
    CHECK(r.canvas().selection == kept);
    r.press("Escape");
    CHECK(r.at() == "Canvas");
    r.press("Down");
    CHECK(r.at() != "Canvas");

    r.press("V");
    r.find("Preview");
    const auto light = r.designer().scene.light;
    r.press("Enter");
    r.press("Right", 3);
    r.press("Space");
    r.press("Up", 3);
    r.press("Space");
    r.play("frames 2");
    CHECK(r.designer().scene.light != light);
    // The mouse takes over where it moves.
    r.play("move 400 300\nframes 2");
    const auto left = r.designer().scene.light;
    r.press("Up", 3);
    CHECK(r.designer().scene.light == left);
}

TEST_CASE("focus: each widget of a dialog is come to, and Escape closes it") {
    for (const char* keys : {"Ctrl+E", "Ctrl+O", "Ctrl+I", "Ctrl+Shift+S", "F1"}) {
        CAPTURE(keys);
        Keys r;
        const std::set<std::string> behind = r.on_screen();
        r.press(keys);
        r.play("frames 4");
        std::set<std::string> inside;
        for (const std::string& name : r.on_screen())
            if (!behind.contains(name)) inside.insert(name);
        REQUIRE(!inside.empty());
        r.press("Down");
        const std::set<std::string> reached = r.all_along();
        for (const std::string& name : inside) {
            CAPTURE(name);
            CHECK((reached.contains(name) || name == "Accept"));  // disabled while there is no file's name
        }
        r.press("Escape", 2);
        r.play("frames 3");
        CHECK(r.on_screen() == behind);
    }
}

TEST_CASE("focus: a question is answered by Enter, or by the button that has the focus") {
    for (const bool walked : {false, true}) {
        Keys r;
        r.press("Ctrl+D");
        r.play("frames 3");
        REQUIRE(r.layers().size() == 2);
        r.press("Ctrl+N");
        r.play("frames 4");
        if (walked) {
            REQUIRE(r.go_to("Discard"));
            r.press("Enter");
            r.play("frames 4");
            CHECK(r.layers().size() == 1);
        } else {
            r.press("Enter");  // Save: where to is asked
            r.play("frames 4");
            CHECK(r.layers().size() == 2);
            CHECK(talking(r.designer()));
        }
    }
}
