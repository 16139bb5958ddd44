// The brush under the pointer as it will land, on the canvas and on the object.
#pragma once

#include <functional>

#include "ui/hemisphere_canvas.h"

namespace nacre::ui {

// On the canvas, copies included.
void draw_brush(const CanvasState& state, const CanvasFrame& frame, const CanvasContents& contents);

// On the object: how much, from 0 to 1, the mark of a brush at normal `at` covers what facets of normal h
// light. Keeps no reference to `distribution`. Null where the tool in hand is no brush.
std::function<double(dvec3 h)> brush_veil(const CanvasState& state, const Distribution& distribution,
                                          std::size_t chosen, dvec3 at);

}  // namespace nacre::ui
