// Two ways to bring the mean normal of the facets to n.
#pragma once

#include "ui/hemisphere_canvas.h"

namespace nacre::ui {

// Both are dim where the mean normal lies along n, and while a layer is shown alone. Where p cannot be
// balanced the reason stands below the canvas until p changes.
void balance_button(CanvasState& state, const std::optional<dvec3>& mean, Distribution& distribution);
void straighten_button(const std::optional<dvec3>& mean, Distribution& distribution);

inline constexpr const char* balance_text = "Balance";
inline constexpr const char* straighten_text = "Straighten";

}  // namespace nacre::ui
