// What stands below the tools: the numbers of the chosen one.
#pragma once

#include "ui/hemisphere_canvas.h"
#include "ui/toolbar_row.h"

namespace nacre::ui {

// The row holds on to all that it is made of. `mean` as of CanvasSight.
ToolbarRow tool_row(CanvasTool tool, CanvasState& state, const std::optional<dvec3>& mean,
                    Distribution& distribution);

}  // namespace nacre::ui
