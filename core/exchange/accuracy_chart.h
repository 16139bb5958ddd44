// Error over time as a plot.
#pragma once

#include "core/exchange/accuracy_points.h"
#include "core/plot/point_plot.h"

namespace nacre {

PointPlot accuracy_chart(const DesignAccuracy& design, ChartOf quantity);

std::string chart_file(const std::string& stem, ChartOf quantity);  // STEM-g.svg, STEM-R.svg

}  // namespace nacre
