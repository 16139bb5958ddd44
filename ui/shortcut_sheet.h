// All keys, and what the mouse does, on one sheet.
#pragma once

#include <string>
#include <vector>

namespace nacre::ui {

struct SheetLine {
    std::string keys;
    std::string about;
};

struct SheetGroup {
    std::string title;
    std::vector<SheetLine> lines;
};

// From the list of commands and of the canvas's tools, and the mouse's part.
std::vector<SheetGroup> shortcut_groups();

// Draws the sheet; false once it is closed.
bool shortcut_sheet();

// The same as tables of Markdown, for the manual.
std::string shortcuts_markdown();

}  // namespace nacre::ui
