// The keyboard as Dear ImGui has it, before 1.87 and since. Keys go by GLFW's numbers, which for letters,
// digits and signs are their ASCII codes, letters in upper case.
#pragma once

#include <optional>
#include <string_view>

struct ImGuiIO;
struct ImVec2;

namespace nacre::ui {

namespace key {
inline constexpr int escape = 256, enter = 257, tab = 258, remove = 261, right = 262, left = 263, down = 264,
                     up = 265, page_up = 266, page_down = 267, f6 = 295, f10 = 299, menu = 348;
}

// The number of a key that has a name of more than one letter: "Escape", "F12".
std::optional<int> named_key(std::string_view name);

// Before the first frame: older versions are told here which number means what to them.
void map_keys(ImGuiIO& io);

// Input of the next frame. A key that no shortcut can have is left out.
void tell_key(ImGuiIO& io, int number, bool down);
void tell_modifiers(ImGuiIO& io, bool ctrl, bool shift, bool alt);
void tell_pointer(ImGuiIO& io, const ImVec2& pixel);
void tell_left_button(ImGuiIO& io, bool down);
void tell_wheel(ImGuiIO& io, float notches);

// All that is told goes into the next frame, for hosts that make a frame for each event; else newer versions
// spread what comes fast over several.
void take_input_at_once(ImGuiIO& io);

// Whether input that was told waits for a later frame.
bool input_waits();

// Whether it goes down in this frame. `repeat`: also while it is held, as typed letters repeat.
bool is_key_pressed(int number, bool repeat);

bool is_key_down(int number);

// From now on it is as if it had gone down long before this frame.
void take_key(int number);

// To be called at the end of each frame: whether Tab goes to the next field.
void lend_tab(bool lent);

}  // namespace nacre::ui
