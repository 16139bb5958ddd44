// What the stamp needs of the toolbar: its picture, chosen from pictures, and how it stands.
#pragma once

#include "ui/hemisphere_canvas.h"
#include "ui/toolbar_row.h"

namespace nacre::ui {

// Picture and angle are this wide.
void add_stamp(ToolbarRow& row, CanvasState& state, float width);

}  // namespace nacre::ui
