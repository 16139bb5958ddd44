// Measured points over two logarithmic axes, joined by lines.
#pragma once

#include <string>
#include <vector>

#include "core/plot/plot_pen.h"

namespace nacre {

// Coordinates are above 0 and finite along x, anything along y.
struct PointSeries {
    std::string name;
    std::string note = {};  // below the name in the legend
    Ink ink = Ink::plain;
    bool joined = true;  // else marks alone
    std::vector<glm::dvec2> points = {};
    std::vector<std::string> labels = {};      // beside the marks of `points`, or empty
    std::vector<glm::dvec2> thin_points = {};  // a thin line without marks
};

// What lies above the plot, or is NaN, is cut off; what lies below is drawn at its foot.
struct PointPlot {
    std::string title, subtitle;
    Axis x, y;
    std::vector<PointSeries> series = {};
    std::vector<std::string> notes = {};  // below the legend, a paragraph each
};

// Logarithmic axes: x spans the points with a margin, y the decades of those within [y_min, y_max].
void fit_axes(PointPlot& plot, double y_min, double y_max);

// Series differ in ink and in their marks.
void draw_point_plot(PlotPen& pen, const PointPlot& plot, const PlotBox& box);

}  // namespace nacre
