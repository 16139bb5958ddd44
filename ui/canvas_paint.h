// The brush on the canvas.
#pragma once

#include "ui/brush_surface.h"

namespace nacre::ui {

// Press and drag paint on the chosen layer or its mask, or, where that is no painted one, on a new painted
// layer after it. With Ctrl or Alt a press picks the value that is there; on the canvas a drag with Shift
// sizes the brush, and a click with Shift draws a line from where the last stroke ended. `seen` is p as it is
// shown. Returns whether the pointer is the brush's.
bool paint_layers(CanvasState& state, const BrushSurface& surface, const FacetDistribution* seen,
                  Distribution& distribution, std::size_t& chosen);

// All that is selected at once, as that brush combines by value and opacity; without effect where nothing is
// selected.
void paint_selection(const CanvasState& state, const Brush& brush, Distribution& distribution,
                     std::size_t& chosen);

}  // namespace nacre::ui
