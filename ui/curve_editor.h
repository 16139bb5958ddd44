// p(theta) as points on a plot, and the chosen point as numbers.
#pragma once

#include <imgui.h>

#include <cstddef>
#include <optional>

#include "ui/curve_axes.h"

namespace nacre::ui {

// What the editor remembers between frames; no part of the document.
struct CurveView {
    bool logarithmic = true;
    double angle_end = 90;              // degrees
    std::optional<std::size_t> chosen;  // point
    struct Held {
        CurveAxes axes;  // as they were when the point was taken: nothing moves under the pointer
        ImVec2 offset;   // pixels from the pointer to the point
    };
    std::optional<Held> held;  // the chosen point, by the left button
};

// A press on the plot takes a point or adds one; a right click on a point, or Delete, removes it. Angles stay
// in rising order. Returns whether the curve changed.
bool curve_editor(CurveView& view, CurveLobe& curve);

}  // namespace nacre::ui
