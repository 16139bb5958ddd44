// p(theta) as points on a plot, and the same points as numbers.
#pragma once

#include "core/design/design.h"

namespace nacre::ui {

// Drag a point; double click on the plot adds one, right click on a point removes it. Angles stay in
// rising order. Returns whether the curve changed.
bool curve_editor(CurveLobe& curve);

}  // namespace nacre::ui
