// A drag that Escape takes back.
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

AtRest at_rest(const Designer& designer);

// The design as its newest step of undo has it, and the rest as it was.
void take_back(Designer& designer);

}  // namespace nacre
