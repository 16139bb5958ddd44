// The brush on the canvas.
#pragma once

#include "ui/brush_surface.h"

namespace nacre::ui {

// Press and drag paint on the chosen layer, or, where that is no
// painted one, on a new painted layer after it. Returns whether the pointer is the brush's.
bool paint_layers(CanvasState& state, const BrushSurface& surface, Distribution& distribution,
                  std::size_t& chosen);

// Adds a painted layer after the chosen one and chooses it; without effect where there is no room.
void add_painted_layer(Distribution& distribution, std::size_t& chosen);

// The brush under the pointer as it will land, copies included.
void draw_brush(const CanvasState& state, const CanvasFrame& frame, const CanvasContents& contents);

}  // namespace nacre::ui
