#include "core/plot/draw_plot.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/image/luminance.h"
#include "core/plot/draw_parts.h"

namespace nacre {
namespace {

constexpr double title_ems = 1.9;    // height of the line above
constexpr double numbers_ems = 1.5;  // of the numbers below an axis, ...
constexpr double foot_ems = 2.7;     // ... and of its title too
constexpr double gap_ems = 1.4;      // between the plot and its legend

double widest_number(const PlotPen& pen, const Axis& axis, double height) {
    double widest = 0;
    for (const Tick& tick : axis.ticks(static_cast<int>(height / (2 * pen.em()))))
        widest = std::max(widest, pen.text_width(tick.label));
    return widest;
}

// The box without its legend, which is as wide as it needs to be.
PlotBox take_legend(PlotLayout& layout, double width, const PlotPen& pen) {
    PlotBox rest = layout.box;
    rest.low.y += title_ems * pen.em();
    const double most = 0.6 * rest.size().x;
    layout.legend = {{rest.high.x - std::min(width, most), rest.low.y}, rest.high};
    rest.high.x = layout.legend.low.x - gap_ems * pen.em();
    return rest;
}

// The bilinear value of a slice at angles within it.
dvec3 slice_value(const SlicePlot& plot, glm::dvec2 at) {
    const glm::dvec2 place = at * ((plot.side - 1) / 90.0);
    const glm::ivec2 low = glm::clamp(glm::ivec2(place), 0, plot.side - 2);
    const glm::dvec2 t = place - glm::dvec2(low);
    const auto value = [&](int x, int y) { return plot.values[static_cast<std::size_t>(y * plot.side + x)]; };
    return glm::mix(glm::mix(value(low.x, low.y), value(low.x + 1, low.y), t.x),
                    glm::mix(value(low.x, low.y + 1), value(low.x + 1, low.y + 1), t.x), t.y);
}

std::optional<PlotReading> read_curves(const CurvePlot& plot, double x) {
    PlotReading reading{.at = {x, 0}, .values = {}};
    for (std::size_t i = 0; i < plot.series.size(); ++i) reading.values.push_back(plot.value(i, x));
    return reading;
}

template <class... Work>
struct Overloaded : Work... {
    using Work::operator()...;
};
template <class... Work>
Overloaded(Work...) -> Overloaded<Work...>;

}  // namespace

PlotBox inside_axes(PlotBox rest, const Axis& y, const PlotPen& pen) {
    rest.high.y -= foot_ems * pen.em();
    rest.low.x += widest_number(pen, y, rest.size().y) + 0.8 * pen.em();
    rest.low.y += 0.4 * pen.em();
    return rest;
}

PlotLayout layout_plot(const Plot& plot, const PlotBox& box, const PlotPen& pen) {
    PlotLayout layout{.box = box, .area = box, .legend = box};
    const double em = pen.em();
    std::visit(Overloaded{[&](const CurvePlot& curves) {
                              layout.area = inside_axes(
                                  take_legend(layout, legend_width(pen, curves.series), pen), curves.y, pen);
                          },
                          [&](const LobePlot& lobe) {
                              layout.area = take_legend(layout, legend_width(pen, lobe.curves.series), pen);
                              layout.area.low += glm::dvec2(2.6, 1.2) * em;
                              layout.area.high -= glm::dvec2(2.6, numbers_ems) * em;
                          },
                          [&](const ShapePlot& shape) {
                              layout.area = take_legend(layout, colour_bar_width(pen, shape.radius), pen);
                              layout.area.low += 0.6 * em;
                              layout.area.high -= 0.8 * em;
                          },
                          [&](const SlicePlot& slice) {
                              layout.area = inside_axes(
                                  take_legend(layout, colour_bar_width(pen, slice.shade), pen), slice.y, pen);
                              // A square, with its legend beside it.
                              const double side = std::min(layout.area.size().x, layout.area.size().y);
                              layout.area.high.x = layout.area.low.x + side;
                              const double shift = layout.legend.low.x - layout.area.high.x - gap_ems * em;
                              layout.legend.low.x -= shift, layout.legend.high.x -= shift;
                              layout.legend.high.y = layout.area.high.y + 0.6 * em;
                          }},
               plot.contents);
    return layout;
}

std::optional<PlotReading> read_plot(const Plot& plot, const PlotLayout& layout, const ShapeView& view,
                                     glm::dvec2 pixel) {
    if (!layout.area.holds(pixel)) return {};
    const glm::dvec2 part = (pixel - layout.area.low) / layout.area.size();
    return std::visit(
        Overloaded{[&](const CurvePlot& curves) { return read_curves(curves, curves.x.value(part.x)); },
                   [&](const LobePlot& lobe) -> std::optional<PlotReading> {
                       const HalfDisk disk = half_disk(layout.area);
                       if (glm::length(pixel - disk.middle) > disk.radius) return {};
                       return read_curves(lobe.curves, lobe_angle(layout, pixel));
                   },
                   [&](const ShapePlot& shape) { return read_shape(shape, layout, view, pixel); },
                   [&](const SlicePlot& slice) -> std::optional<PlotReading> {
                       const glm::dvec2 at(slice.x.value(part.x), slice.y.value(1 - part.y));
                       const dvec3 value = slice_value(slice, at);
                       return PlotReading{.at = at, .values = {value.x, value.y, value.z}};
                   }},
        plot.contents);
}

PlotPixels slice_pixels(const SlicePlot& slice) {
    PlotPixels pixels{.size = {slice.side, slice.side}, .colours = {}};
    pixels.colours.reserve(slice.values.size());
    for (int row = slice.side; row-- > 0;)
        for (int column = 0; column < slice.side; ++column)
            pixels.colours.push_back(shade_colour(slice.shade.place(
                luminance(slice.values[static_cast<std::size_t>(row * slice.side + column)]))));
    return pixels;
}

void draw_slice(PlotPen& pen, const SlicePlot& plot, const PlotLayout& layout,
                const std::optional<PlotReading>& reading) {
    const PlotBox& area = layout.area;
    draw_axes(pen, area, plot.x, plot.y);
    pen.picture(area, plot);
    if (reading) {
        const double x = std::lerp(area.low.x, area.high.x, plot.x.place(reading->at.x));
        const double y = std::lerp(area.high.y, area.low.y, plot.y.place(reading->at.y));
        straight(pen, {x, area.low.y}, {x, area.high.y}, Ink::text, hair(pen));
        straight(pen, {area.low.x, y}, {area.high.x, y}, Ink::text, hair(pen));
        std::vector<std::string> lines = {fmt::format("\u03b8h {:.1f}\u00b0", reading->at.x),
                                          fmt::format("\u03b8d {:.1f}\u00b0", reading->at.y)};
        for (std::string& line : colour_lines(reading->values, plot.shade)) lines.push_back(std::move(line));
        draw_reading(pen, layout.legend, lines);
    }
    draw_colour_bar(pen, layout.legend, plot.shade);
}

void draw_plot(PlotPen& pen, const Plot& plot, const PlotLayout& layout, const ShapeView& view,
               const std::optional<PlotReading>& reading) {
    const glm::dvec2 head = layout.box.low + glm::dvec2(0, 0.6 * pen.em());
    pen.text(head, plot.title, Ink::text);
    pen.text(head + glm::dvec2(pen.text_width(plot.title) + pen.em(), 0), plot.subtitle, Ink::quiet);
    std::visit(Overloaded{[&](const CurvePlot& curves) { draw_curves(pen, curves, layout, reading); },
                          [&](const LobePlot& lobe) { draw_lobe(pen, lobe, layout, reading); },
                          [&](const ShapePlot& shape) { draw_shape(pen, shape, layout, view, reading); },
                          [&](const SlicePlot& slice) { draw_slice(pen, slice, layout, reading); }},
               plot.contents);
}

}  // namespace nacre
