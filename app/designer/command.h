// What a menu, a shortcut or a button asks the designer to do: one file for each, app/designer/commands/
// NAME.cpp, and its line in command_list.inc, which the menus, the shortcuts, their sheet and the manual
// follow.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "app/designer/designer.h"
#include "ui/commands.h"

namespace nacre {

struct Command {
    ui::CommandInfo info;
    bool (*enabled)(const Designer& designer) = nullptr;  // null: always
    bool (*checked)(const Designer& designer) = nullptr;  // null: never
    // Several items of the menu in place of one; null: it is one.
    std::vector<ui::CommandChoice> (*choices)(const Designer& designer) = nullptr;
    void (*perform)(Designer& designer, std::size_t which);  // of the choices, from 0
};

// In the order of the menus.
std::span<const Command* const> commands();
ui::CommandInfos command_infos();

#define COMMAND(name) extern const Command name##_command;
#include "app/designer/command_list.inc"
#undef COMMAND

// The commands as they are now.
std::vector<ui::CommandState> command_states(const Designer& designer);

// Without effect while a dialog has the keyboard or the command is disabled.
void perform(Designer& designer, const Command& command, std::size_t which = 0);
void perform(Designer& designer, const ui::Order& order);

}  // namespace nacre
