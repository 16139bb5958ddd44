// One plot, and what the pointer does on it.
#pragma once

#include "ui/plots_panel.h"

namespace nacre::ui {

// Fills the rest of the window. A drag moves the light of a lobe or turns a shape. Returns what is under the
// pointer.
std::optional<PlotReading> plot_view(PlotsState& state, const Plot& plot, ImTextureID slice);

}  // namespace nacre::ui
