// The handles of the layers on the canvas.
#pragma once

#include <optional>
#include <string>

#include "core/paint/lobe_handles.h"
#include "ui/hemisphere_canvas.h"

namespace nacre::ui {

// The handle under the pointer, of the chosen layer first; nothing where there is none.
std::optional<GrabbedHandle> handle_under(const CanvasFrame& frame, const Distribution& distribution,
                                          std::size_t chosen);

// To be called right after the canvas's item: press and drag. A press on another layer's axis chooses that
// layer; a double click on an axis puts it upright. Returns whether the pointer is the handles'.
bool handle_layers(CanvasState& state, const CanvasFrame& frame, Distribution& distribution,
                   std::size_t& chosen);

void draw_handles(const CanvasState& state, const CanvasFrame& frame, const Distribution& distribution,
                  std::size_t chosen);

// The numbers that the held handle changes; empty while none is held.
std::string handle_text(const CanvasState& state, const Distribution& distribution);

}  // namespace nacre::ui
