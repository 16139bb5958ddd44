// What a menu, a shortcut or a button asks the program to do.
#pragma once

#include <optional>
#include <string>

namespace nacre::ui {

enum class Command { new_design, open, save, save_as, undo, redo, quit, reset_camera };

struct MenuState {
    bool can_undo = false;
    bool can_redo = false;
    std::string title;  // shown at the right of the bar
};

// Draws the main menu bar; its height is ImGui::GetFrameHeight().
std::optional<Command> menu_bar(const MenuState& state);

// The command of a shortcut pressed in this frame; none while a text field has the keyboard or a mouse
// button is down. Hosts number letter keys by their upper-case ASCII code.
std::optional<Command> pressed_shortcut();

}  // namespace nacre::ui
