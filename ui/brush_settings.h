// What is set of the brush more rarely than its radius: a list of brushes, and the rest of its numbers.
#pragma once

#include "ui/hemisphere_canvas.h"

namespace nacre::ui {

inline constexpr const char* brush_settings_text = "Brush\u2026";

// The button that opens them.
void brush_settings(CanvasState& state);

}  // namespace nacre::ui
