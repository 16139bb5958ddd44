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
    std::optional<PaintTool> paints = {};
    std::optional<SelectTool> selects = {};
};

std::span<const ToolEntry> canvas_tools();
std::string tool_tooltip(const ToolFace& face);

// What the hand does with the tool, while a button is down or goes up, is an edit of its name.
void name_edit_by_tool(CanvasTool tool);

// What a tool paints or selects with, if it does.
std::optional<PaintTool> paints_with(CanvasTool tool);
std::optional<SelectTool> selects_with(CanvasTool tool);

// Whether the object is worked on too; the others leave the light there to the pointer.
bool works_on_object(CanvasTool tool);

// What of the chosen layer the tools work on.
LayerPart part_in_hand(const CanvasState& state, const Distribution& distribution, std::size_t chosen);

}  // namespace nacre::ui
