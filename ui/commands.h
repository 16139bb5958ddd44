// Commands as the menus, the shortcuts and the sheet of shortcuts show them. What they do is not known here.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace nacre::ui {

struct CommandInfo {
    // That it stands in, "File/Open recent" in a menu within a menu; a group of the sheet alone where `label`
    // is null.
    const char* menu;
    const char* label;           // in the menu
    const char* keys;            // as parse_key() reads them, or null, or nine_digits; a sign is typed
    const char* also = nullptr;  // other keys
    const char* about;  // one line for tooltip, sheet and manual; null where its choices have their own
    bool begins_group = false;  // a line above it in the menu
    bool repeats = false;       // goes on while its keys are held
};

// Each of them is a choice of its own.
inline constexpr const char* nine_digits = "1-9";

using CommandInfos = std::span<const CommandInfo* const>;

// A place in the list of commands, and which of its choices where it has several.
struct Order {
    std::size_t command;
    std::size_t which = 0;
    bool operator==(const Order&) const = default;
};

struct CommandChoice {
    std::string label, about;
};

// A command as it is in this frame.
struct CommandState {
    const CommandInfo* info;
    bool enabled = true;
    bool checked = false;
    std::optional<std::vector<CommandChoice>> choices = {};  // in place of the label
};

// Draws the main menu bar; its height is ImGui::GetFrameHeight(). `title` stands at its right.
std::optional<Order> menu_bar(std::span<const CommandState> commands, const std::string& title);

// To be called at the end of each frame: Tab goes to the next field only while one is being typed in, else it
// is a shortcut.
void reserve_tab();

// The command of a shortcut pressed in this frame; none while a text field has the keyboard, a mouse button
// is down or something is popped up.
std::optional<Order> pressed_shortcut(CommandInfos commands);

}  // namespace nacre::ui
