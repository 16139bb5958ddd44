// The canvas: p(h) on the hemisphere of facet normals, with its grid, its colour scale and the cursor's
// numbers.
#pragma once

#include <imgui.h>

#include <optional>

#include "core/model/facet_distribution.h"
#include "core/paint/density_picture.h"
#include "core/paint/hemisphere_view.h"

namespace nacre::ui {

// What the canvas remembers between frames; no part of the document.
struct CanvasState {
    HemisphereCamera camera;
    bool logarithmic = false;
};

// Where the canvas lies in this frame, and what its pixels stand for.
struct CanvasFrame {
    ImVec2 low, high;  // left top, right bottom
    HemisphereView view;
    std::optional<dvec3> cursor;  // the normal under the pointer

    ImVec2 screen(dvec3 h) const;
    glm::dvec2 pixel(ImVec2 screen) const;  // as `view` counts
};

// What is shown on the canvas. `p` is null for a design without facets.
struct CanvasContents {
    const FacetDistribution* p = nullptr;
    ImTextureID picture = nullptr;  // null while there is none
    ImVec2 picture_size;            // pixels from the canvas's left top corner that it covers
    DensityScale scale;
};

// The buttons above the canvas. Fills the rest of the window but for the legend below it, and lets wheel and
// drags move the camera.
CanvasFrame begin_canvas(CanvasState& state);

// Picture, grid, mean normal, and the legend below.
void end_canvas(const CanvasFrame& frame, const CanvasContents& contents);

}  // namespace nacre::ui
