// Error beside time as a chart.
#pragma once

#include "core/exchange/accuracy_points.h"
#include "core/exchange/log_chart.h"

namespace nacre {

LogChart accuracy_chart(const DesignAccuracy& design, ChartOf quantity);

std::string chart_file(const std::string& stem, ChartOf quantity);  // STEM-g.svg, STEM-R.svg

}  // namespace nacre
