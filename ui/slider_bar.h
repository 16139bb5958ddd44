#pragma once

#include "ui/widgets.h"

namespace nacre::ui {

// The bare field of a slider, over the width set for the next item. Typing may leave the ends. Without
// `marked` no line stands at the bar's end, where it would cross a text that fills the field.
void slider_bar(const SliderSpec& spec, double& value, bool marked = true);

}  // namespace nacre::ui
