// Draws a plot into a box, and finds what is under the pointer.
#pragma once

#include <optional>

#include "core/plot/plot_pen.h"

namespace nacre {

// From where a shape is seen, degrees; see HemisphereCamera.
struct ShapeView {
    double yaw = -25, pitch = 25;
    double zoom = 1;  // 1 shows all of it

    bool operator==(const ShapeView&) const = default;
};

// The layout of a plot.
struct PlotLayout {
    PlotBox box;     // all of it
    PlotBox area;    // within the axes
    PlotBox legend;  // at the right
};

PlotLayout layout_plot(const Plot& plot, const PlotBox& box, const PlotPen& pen);

// What is under the pointer.
struct PlotReading {
    glm::dvec2 at;               // x (curves), theta_2 (lobe), theta_2 and phi_2 (shape), theta_h and theta_d
    std::vector<double> values;  // of each series, or red, green and blue
    std::size_t vertex = 0;      // of a shape
};
std::optional<PlotReading> read_plot(const Plot& plot, const PlotLayout& layout, const ShapeView& view,
                                     glm::dvec2 pixel);

// The angle of k2 in the plane of incidence toward which a pixel lies from a lobe's middle, degrees.
double lobe_angle(const PlotLayout& layout, glm::dvec2 pixel);

void draw_plot(PlotPen& pen, const Plot& plot, const PlotLayout& layout, const ShapeView& view,
               const std::optional<PlotReading>& reading);

// The luminance of a slice as colours, theta_d rising upward.
PlotPixels slice_pixels(const SlicePlot& slice);

}  // namespace nacre
