#pragma once

#include "ui/widgets.h"

namespace nacre::ui {

// The bare field of a slider, over the width set for the next item. Typing may leave the ends.
void slider_bar(const SliderSpec& spec, double& value);

}  // namespace nacre::ui
