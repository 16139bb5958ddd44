// The buttons above the canvas: tools, the brush's numbers, how p is shown.
#pragma once

#include "ui/hemisphere_canvas.h"

namespace nacre::ui {

// Two rows, or more where the canvas is narrow. Takes the keys of the tools.
// `mean` as of CanvasSight.
void canvas_toolbar(CanvasState& state, const std::optional<dvec3>& mean, Distribution& distribution,
                    std::size_t& chosen);

// How p is shown: scale, side and shape, for the legend below the canvas.
void view_choices(CanvasState& state);

// Makes the brush's radius larger by so many steps of a key, or smaller.
void resize_brush(CanvasState& state, int steps);

// Draws a tool's sign into a square.
void draw_tool_icon(const ToolFace& face, ImVec2 corner, float side, ImU32 colour);

}  // namespace nacre::ui
