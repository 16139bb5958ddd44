// A picture on which the tools work: the canvas, or the sphere under its light.
#pragma once

#include <functional>

#include "ui/hemisphere_canvas.h"

namespace nacre::ui {

struct BrushSurface {
    Surface surface;
    bool hovered = false;
    bool active = false;              // the item that is the picture holds the mouse
    std::optional<dvec3> pointed_at;  // the normal under the pointer
    glm::dvec2 pixel;                 // of the pointer
    // The normal at a pixel, or near it; nothing where none is near.
    std::function<std::optional<dvec3>(glm::dvec2 pixel)> normal;
};

// The left button with any tool but the handles: press and drag. `seen` is p as the surface shows it. Returns
// whether the pointer is the tool's.
bool use_tool(CanvasState& state, const BrushSurface& surface, const FacetDistribution* seen,
              Distribution& distribution, std::size_t& chosen);

}  // namespace nacre::ui
