// The tools of the canvas in their order, with what each does.
#pragma once

#include <span>
#include <string>

#include "ui/hemisphere_canvas.h"

namespace nacre::ui {

struct ToolEntry {
    CanvasTool tool;
    const char* name;
    char key;
    const char* about;  // one line for tooltip, sheet and manual
    const char* more;   // for the tooltip alone
};

std::span<const ToolEntry> canvas_tools();
std::string tool_tooltip(const ToolEntry& entry);

}  // namespace nacre::ui
