// What the stamp needs of the toolbar: its picture, chosen from pictures, and how it stands.
#pragma once

#include "ui/hemisphere_canvas.h"

namespace nacre::ui {

// Each of its fields is this wide; `gap` between them.
void stamp_row(CanvasState& state, float width, float gap);

}  // namespace nacre::ui
