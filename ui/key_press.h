// Keys with their modifiers as text: what shortcuts, menus and event scripts are written in.
#pragma once

#include <optional>
#include <string_view>

namespace nacre::ui {

struct KeyPress {
    int key = 0;  // GLFW's number, a letter's upper-case ASCII code
    bool ctrl = false;
    bool shift = false;
    bool alt = false;
    bool operator==(const KeyPress&) const = default;
};

// The number of a printing key that GLFW names by its place on the US keyboard: that of the letter, digit or
// sign that the layout has there (`name`, may be null), so that Ctrl+Z is the key with the Z. The row of
// digits stays theirs where it needs Shift for them, and so does the place where no other number fits.
int key_on_layout(int position, const char* name);

// "Ctrl+Shift+S", "Enter", "F12", "[".
std::optional<KeyPress> parse_key(std::string_view text);

// Whether it goes down in this frame, with these modifiers and no others. `repeat`: also while it is held, as
// typed letters repeat.
bool is_pressed(const KeyPress& press, bool repeat);

// Whether the sign was typed in this frame, by whatever keys the layout has it on.
bool is_typed(char sign);

}  // namespace nacre::ui
