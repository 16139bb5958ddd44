// Where an edit ends: as one step of undo, or taken back by Escape.
#pragma once

#include <cstddef>

#include "app/designer/layout.h"
#include "app/preview/scene.h"
#include "core/paint/hemisphere_view.h"
#include "ui/plots_panel.h"

namespace nacre {

struct Designer;

// What a drag may change and no step of undo keeps, as it was while nothing was held.
struct AtRest {
    Scene scene;
    HemisphereCamera camera;
    Layout layout;
    ui::PlotsState plots;
    double divider = 0.5;
    std::size_t layer = 0;  // chosen
};

// At the beginning of a frame: a click on a slider is done where no second one makes a double click of it.
void end_click(Designer& designer);

// At the end of a frame. A drag that Escape takes back leaves the design as its newest step of undo has it,
// and the rest as it was; else each drag, double click or typed text is one step once nothing is
// held and what a picture makes of it has come.
void end_edit(Designer& designer);

}  // namespace nacre
