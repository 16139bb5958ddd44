// Plots over pairs of directions: the lobe of one incidence, and the slice.
#pragma once

#include "core/plot/plot.h"

namespace nacre {

Plot lobe_plot(const Tables& tables, const PlotSettings& settings);
Plot shape_plot(const Tables& tables, const PlotSettings& settings);
Plot slice_plot(const Tables& tables, const PlotSettings& settings);

}  // namespace nacre
