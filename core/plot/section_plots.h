// Plots over one angle: of R, P, p and F.
#pragma once

#include "core/plot/plot.h"

namespace nacre {

Plot albedo_plot(const Tables& tables, const PlotSettings& settings);  // the tables hold R
Plot masking_plot(const Tables& tables, const PlotSettings& settings);
Plot density_plot(const Tables& tables, const PlotSettings& settings);
Plot fresnel_plot(const Tables& tables, const PlotSettings& settings);

}  // namespace nacre
