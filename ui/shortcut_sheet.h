// All keys, and what the mouse does, on one sheet.
#pragma once

#include <string>
#include <vector>

#include "ui/commands.h"

namespace nacre::ui {

struct SheetLine {
    std::string keys;
    std::string about;
};

struct SheetGroup {
    std::string title;
    std::vector<SheetLine> lines;
};

// Of the commands and of the canvas's tools, and the mouse's part.
std::vector<SheetGroup> shortcut_groups(CommandInfos commands);

// Draws the sheet; false once it is closed, which the key that opened it does too.
bool shortcut_sheet(CommandInfos commands, const char* opened_by);

// The same as tables of Markdown, for the manual.
std::string shortcuts_markdown(CommandInfos commands);

}  // namespace nacre::ui
