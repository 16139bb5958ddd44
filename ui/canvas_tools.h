// The tools of the canvas in their order.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "ui/hemisphere_canvas.h"

namespace nacre::ui {

struct ToolEntry {
    CanvasTool tool;
    const ToolFace* face;
    std::optional<PaintTool> paints;  // none of handles and grab
};

std::span<const ToolEntry> canvas_tools();
std::string tool_tooltip(const ToolFace& face);

// What the hand does with the tool, while a button is down or goes up, is an edit of its name.
void name_edit_by_tool(CanvasTool tool);

// What a tool paints with, if it does.
std::optional<PaintTool> paints_with(CanvasTool tool);

}  // namespace nacre::ui
