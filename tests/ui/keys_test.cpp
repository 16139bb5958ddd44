// Which key is which on the layouts of several countries, and signs that are typed.
#include <doctest/doctest.h>

#include <optional>
#include <vector>

#include "tests/ui/panel_rig.h"
#include "tests/ui/some_commands.h"
#include "ui/key_press.h"
#include "ui/keys.h"

using namespace nacre;

TEST_CASE("keys: letters are those of the layout") {
    using ui::key_on_layout;
    CHECK(key_on_layout('Z', "z") == 'Z');
    CHECK(key_on_layout('Y', "z") == 'Z');  // German
    CHECK(key_on_layout('Z', "y") == 'Y');
    CHECK(key_on_layout('Q', "a") == 'A');  // French: Ctrl+A selects and does not quit
    CHECK(key_on_layout('A', "q") == 'Q');
    CHECK(key_on_layout(';', "m") == 'M');
    CHECK(key_on_layout('M', ",") == ',');
    CHECK(key_on_layout('Q', "'") == '\'');      // Dvorak
    CHECK(key_on_layout('Z', "\u044f") == 'Z');  // Russian: by place
    CHECK(key_on_layout('[', "\u00fc") == '[');
    CHECK(key_on_layout('S', nullptr) == 'S');
    CHECK(key_on_layout('S', "") == 'S');
}

TEST_CASE("keys: the row of digits stays theirs where it needs Shift for them") {
    using ui::key_on_layout;
    CHECK(key_on_layout('1', "1") == '1');
    CHECK(key_on_layout('1', "&") == '1');  // French
    CHECK(key_on_layout('6', "-") == '6');
    CHECK(key_on_layout('2', "\u00e9") == '2');
    CHECK(key_on_layout('2', "\u011b") == '2');  // Czech
}

TEST_CASE("keys: signs are what is typed, with whatever keys") {
    std::vector<ui::Order> pressed;
    PanelRig rig([&] {
        if (const auto command = ui::pressed_shortcut(some_commands::infos())) pressed.push_back(*command);
    });
    ImGuiIO& io = ImGui::GetIO();
    const auto with = [&](bool shift, bool alt, int key, const char* text) {
        rig.hold(false, shift, alt);
        ui::tell_key(io, key, true);
        rig.type(text);
        ui::tell_key(io, key, false);
        rig.hold();
        rig.frame();
    };
    with(false, false, '[', "[");
    with(false, true, '8', "[");  // AltGr+8 of Germany is no layer
    with(false, true, '9', "]");
    with(false, false, ',', ",");
    with(true, false, ';', ".");  // French
    with(true, false, '3', "3");
    with(false, false, '3', "\"");
    with(false, false, '[', "\u00fc");
    using namespace some_commands;
    CHECK(pressed == std::vector<ui::Order>{
                         {smaller}, {smaller}, {larger}, {smaller}, {larger}, {layer, 2}, {layer, 2}});
}

TEST_CASE("keys: what has a name, letters and digits go down in the frame that they are told for") {
    int asked = 0, frames = 0;
    PanelRig rig([&] { frames += ui::is_key_pressed(asked, false); });
    for (const char* name :
         {"Escape", "Enter",       "Tab",      "Backspace", "Insert", "Delete", "Right", "Left", "Down",
          "Up",     "PageUp",      "PageDown", "Home",      "End",    "Space",  "F1",    "F2",   "F11",
          "F12",    "KeypadEnter", "A",        "B",         "Z",      "0",      "1",     "9"}) {
        CAPTURE(name);
        asked = ui::parse_key(name).value().key;
        frames = 0;
        rig.key(asked);
        CHECK(frames == 1);
    }
    asked = ui::key::enter;
    frames = 0;
    rig.key(ui::key::escape);
    CHECK(frames == 0);
}

TEST_CASE("keys: one that is taken is seen by nobody after") {
    int before = 0, after = 0;
    PanelRig rig([&] {
        if (ui::is_key_pressed(ui::key::escape, false)) {
            ++before;
            ui::take_key(ui::key::escape);
        }
        after += ui::is_key_pressed(ui::key::escape, false);
    });
    rig.key(ui::key::escape);
    CHECK(before == 1);
    CHECK(after == 0);
}
