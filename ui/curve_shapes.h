// Curves to begin with.
#pragma once

#include <span>

#include "ui/curve_axes.h"

namespace nacre::ui {

struct CurveShape {
    const char* name;
    const char* explanation;
    CurvePoints points;
};

std::span<const CurveShape> curve_shapes();

}  // namespace nacre::ui
