// Error over time as a plot.
#pragma once

#include "core/plot/point_plot.h"
#include "core/study/accuracy_points.h"

namespace nacre {

PointPlot accuracy_chart(const DesignAccuracy& design, ChartOf quantity);

std::string chart_file(const std::string& stem, ChartOf quantity);  // STEM-g.svg, STEM-R.svg

}  // namespace nacre
