// What is selected, on the canvas.
#pragma once

#include "ui/hemisphere_canvas.h"
#include "ui/toolbar_row.h"

namespace nacre::ui {

// A drag with a tool that selects marks an area: in place of the one before, or with Shift added to it, with
// Ctrl or Alt taken away. A click selects nothing. Returns whether the pointer is the tool's.
bool select_area(CanvasState& state, const CanvasFrame& frame);

// The dashed line around what is selected, and around what is being marked.
void draw_selection(const CanvasState& state, const CanvasFrame& frame);

// What stands in place of the brush's numbers.
ToolbarRow selection_row(CanvasState& state);

}  // namespace nacre::ui
