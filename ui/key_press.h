// Keys with their modifiers as text: what shortcuts, menus and event scripts are written in.
#pragma once

#include <optional>
#include <string_view>

namespace nacre::ui {

struct KeyPress {
    int key =
        0;  // GLFW's number, as hosts fill Dear ImGui's KeysDown; a letter's is its upper-case ASCII code
    bool ctrl = false;
    bool shift = false;
    bool alt = false;
    bool operator==(const KeyPress&) const = default;
};

// "Ctrl+Shift+S", "Enter", "F12", "[".
std::optional<KeyPress> parse_key(std::string_view text);

// Whether it goes down in this frame, with these modifiers and no others. `repeat`: also while it is held, as
// typed letters repeat.
bool is_pressed(const KeyPress& press, bool repeat);

}  // namespace nacre::ui
