// A chart with two logarithmic axes as an SVG file.
#pragma once

#include <string>
#include <vector>

#include "core/exchange/log_axis.h"

namespace nacre {

struct ChartPoint {
    double x = 0, y = 0;
    std::string label = {};  // beside its mark
};

struct ChartLine {
    std::string name;
    std::string note = {};  // below the name in the legend
    std::vector<ChartPoint> points = {};
    std::vector<ChartPoint> faint = {};  // a thin dashed line of the same colour, without marks
    bool joined = true;                  // else marks alone
};

struct ChartAxis {
    std::string title;
    ChartUnit unit = ChartUnit::parts;
};

struct LogChart {
    std::string title;
    std::string subtitle;
    ChartAxis x, y;
    // The vertical axis spans the points, but no more than this: what lies above is cut off, and what lies
    // below stands at the foot.
    double y_least = 1e-6, y_most = 1;
    std::vector<ChartLine> lines = {};
    std::vector<std::string> notes = {};  // below the legend, a paragraph each
};

// Well-formed XML in UTF-8. Lines differ in colour, told apart by colour-blind readers, and in their marks.
std::string svg_chart(const LogChart& chart);

}  // namespace nacre
