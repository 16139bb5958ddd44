// A box of handles about what is selected of the chosen layer, or all of its paint.
#pragma once

#include "ui/hemisphere_canvas.h"
#include "ui/toolbar_row.h"

namespace nacre::ui {

// A drag within the box carries what is in it, its handles stretch it (with Shift in ratio), the knob above
// it turns it (with Shift by steps). Enter or a press outside applies, Escape takes all of it back. Returns
// whether the pointer is the tool's.
bool transform_paint(CanvasState& state, const CanvasFrame& frame, Distribution& distribution,
                     std::size_t& chosen);

void draw_transform(const CanvasState& state, const CanvasFrame& frame);

// What stands in place of the brush's numbers.
ToolbarRow transform_row(CanvasState& state, Distribution& distribution);

// What is on the screen holds; what was selected lies where it was carried to.
void apply_transform(CanvasState& state);

// Whether what is on the screen is neither applied nor taken back: it is no step of undo yet.
bool transform_pending(const CanvasState& state);

}  // namespace nacre::ui
