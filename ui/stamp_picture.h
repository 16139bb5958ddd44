// A stamp as it is drawn: in a list, and under the pointer as it will land.
#pragma once

#include <imgui.h>

#include <functional>
#include <optional>

#include "core/paint/stamps.h"

namespace nacre::ui {

// Where a point of the picture, which reaches from -1 to 1 each way with y up, stands on the screen; nothing
// where it is hidden.
using StampPlace = std::function<std::optional<ImVec2>(glm::dvec2 at)>;

// Draws a stamp's thumbnail as light of this colour, as strong as it paints.
void draw_stamp(const Raster& thumbnail, const StampPlace& place, ImVec4 colour);

// Upright in a square of the screen.
void draw_stamp(const Raster& thumbnail, ImVec2 corner, float side, ImVec4 colour);

}  // namespace nacre::ui
