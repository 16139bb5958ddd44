// What a menu, a shortcut or a button asks the program to do: one list for the menus, the shortcuts, the
// sheet of shortcuts and the manual.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace nacre::ui {

enum class Command {
    new_design,
    open,
    open_recent,  // Order::which of the list
    clear_recent,
    save,
    save_as,
    export_design,
    take_picture,
    picture_folder,
    system_dialogs,
    recover,
    quit,
    undo,
    redo,
    show_panels,
    full_screen,
    reset_camera,
    show_shortcuts,
    brush_smaller,
    brush_larger,
    erase,
    choose_layer  // Order::which of them, from 0
};

// A command, and which of several where it has them.
struct Order {
    Command command;
    std::size_t which = 0;
    Order(Command given, std::size_t index = 0) : command(given), which(index) {}
    bool operator==(const Order&) const = default;
};

struct CommandInfo {
    Command command;
    const char* menu;   // that it stands in; a group of the sheet alone where `label` is null
    const char* label;  // in the menu
    const char* keys;   // as parse_key() reads them, or null; "1-9" for nine of them; a sign is typed
    const char* also;   // other keys, or null
    const char* about;  // one line for tooltip, sheet and manual
    bool begins_group;  // a line above it in the menu
};

std::span<const CommandInfo> all_commands();

struct MenuState {
    bool can_undo = false;
    bool can_redo = false;
    std::string title;                // shown at the right of the bar
    std::vector<std::string> recent;  // paths, newest first
    bool has_system_dialogs = false;  // the desktop has some
    bool uses_system_dialogs = false;
    bool can_recover = false;
    bool panels = true;
    bool full_screen = false;
};

// Draws the main menu bar; its height is ImGui::GetFrameHeight().
std::optional<Order> menu_bar(const MenuState& state);

// To be called at the end of each frame: Tab goes to the next field only while one is being typed in, else it
// is a shortcut.
void reserve_tab();

// The command of a shortcut pressed in this frame; none while a text field has the keyboard, a mouse button
// is down or something is popped up.
std::optional<Order> pressed_shortcut();

}  // namespace nacre::ui
