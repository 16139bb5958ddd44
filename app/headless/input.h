// Input of Dear ImGui 1.86 without a window. Keys have GLFW's numbers (a letter's is its upper-case
// ASCII code), as the desktop's backend gives them.
#pragma once

#include <imgui.h>

#include <optional>
#include <string_view>

namespace nacre {

struct KeyPress {
    int key = 0;
    bool ctrl = false;
    bool shift = false;
    bool alt = false;
    bool operator==(const KeyPress&) const = default;
};

// "Ctrl+Shift+S", "Enter", "F12".
std::optional<KeyPress> parse_key(std::string_view text);

void map_keys(ImGuiIO& io);
void set_key(ImGuiIO& io, const KeyPress& press, bool down);

}  // namespace nacre
