// Parts that the drawings of all plots have in common.
#pragma once

#include "core/plot/draw_plot.h"

namespace nacre {

void text_centred(PlotPen& pen, glm::dvec2 middle, const std::string& text, Ink ink);
void text_before(PlotPen& pen, glm::dvec2 right_middle, const std::string& text, Ink ink);
void straight(PlotPen& pen, glm::dvec2 from, glm::dvec2 to, Ink ink, double width);
void stroked(PlotPen& pen, std::span<const glm::dvec2> points, const Series& series);

double hair(const PlotPen& pen);  // width of a thin line

// The box without the numbers at the left and the numbers and the title below.
PlotBox inside_axes(PlotBox rest, const Axis& y, const PlotPen& pen);

// Grid lines, numbers and the title below, along x and y.
void draw_axes(PlotPen& pen, const PlotBox& area, const Axis& x, const Axis& y);

// The axis as a bar of colours, and the numbers beside it.
void draw_colour_bar(PlotPen& pen, const PlotBox& legend, const Axis& shade);
double colour_bar_width(const PlotPen& pen, const Axis& shade);

// A row for each series with what is read of it.
void draw_legend(PlotPen& pen, const PlotBox& legend, const std::vector<Series>& series, const Axis& x,
                 const std::optional<PlotReading>& reading);
double legend_width(const PlotPen& pen, const std::vector<Series>& series);

// One of a value's colours, `place` in [0, 1].
glm::u8vec3 shade_colour(double place);

// Of each kind of plot.
void draw_curves(PlotPen& pen, const CurvePlot& plot, const PlotLayout& layout,
                 const std::optional<PlotReading>& reading);
void draw_lobe(PlotPen& pen, const LobePlot& plot, const PlotLayout& layout,
               const std::optional<PlotReading>& reading);
void draw_shape(PlotPen& pen, const ShapePlot& plot, const PlotLayout& layout, const ShapeView& view,
                const std::optional<PlotReading>& reading);
void draw_slice(PlotPen& pen, const SlicePlot& plot, const PlotLayout& layout,
                const std::optional<PlotReading>& reading);

std::optional<PlotReading> read_shape(const ShapePlot& plot, const PlotLayout& layout, const ShapeView& view,
                                      glm::dvec2 pixel);

// What a shape or a slice reads, line by line at the top of the legend.
void draw_reading(PlotPen& pen, const PlotBox& legend, const std::vector<std::string>& lines);

// The values of a colour: one line where it is grey, else four.
std::vector<std::string> colour_lines(const std::vector<double>& rgb, const Axis& axis);

// Of a lobe: the middle of its half disk and the radius.
struct HalfDisk {
    glm::dvec2 middle;
    double radius;

    glm::dvec2 at(double angle, double place) const;  // degrees, positive to the right; part of the radius
};
HalfDisk half_disk(const PlotBox& area);

}  // namespace nacre
