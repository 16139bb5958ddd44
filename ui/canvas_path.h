// Lines on the hemisphere as lines on the screen.
#pragma once

#include <imgui.h>

#include "core/model/polar_angles.h"
#include "ui/hemisphere_canvas.h"

namespace nacre::ui {

// Through normals at(0) ... at(1); parts that the dome hides are left out.
template <class At>
void draw_path(const CanvasFrame& frame, const At& at, int steps, ImU32 colour, float width) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.PathClear();
    for (int i = 0; i <= steps; ++i) {
        const dvec3 h = at(static_cast<double>(i) / steps);
        if (frame.view.hidden(h))
            list.PathStroke(colour, 0, width);
        else
            list.PathLineTo(frame.screen(h));
    }
    list.PathStroke(colour, 0, width);
}

}  // namespace nacre::ui
