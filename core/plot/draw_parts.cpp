#include "core/plot/draw_parts.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/image/luminance.h"
#include "core/paint/colour_map.h"
#include "core/plot/colour_series.h"

namespace nacre {
namespace {

constexpr double row_ems = 1.24;    // of a legend
constexpr double swatch_ems = 1.9;  // its line
constexpr double number_ems = 5.2;  // width of a number
constexpr double bar_ems = 1.1;     // width of the bar of colours
constexpr int bar_steps = 64;
constexpr double reading_rows = 5.5;

// The same path as pieces that are drawn and gaps between them.
template <class Draw>
void in_dashes(std::span<const glm::dvec2> points, double on, double off, const Draw& draw) {
    std::vector<glm::dvec2> piece = {points.front()};
    bool drawing = true;
    double left = on;
    for (std::size_t i = 1; i < points.size(); ++i) {
        glm::dvec2 from = points[i - 1];
        double length = glm::length(points[i] - from);
        while (length > left) {
            from += (points[i] - from) * (left / length);
            length -= left;
            if (drawing) {
                piece.push_back(from);
                draw(piece);
            }
            drawing = !drawing;
            left = drawing ? on : off;
            piece = {from};
        }
        left -= length;
        if (drawing) piece.push_back(points[i]);
    }
    if (drawing && piece.size() > 1) draw(piece);
}

}  // namespace

void text_centred(PlotPen& pen, glm::dvec2 middle, const std::string& text, Ink ink) {
    pen.text({middle.x - 0.5 * pen.text_width(text), middle.y}, text, ink);
}

void text_before(PlotPen& pen, glm::dvec2 right_middle, const std::string& text, Ink ink) {
    pen.text({right_middle.x - pen.text_width(text), right_middle.y}, text, ink);
}

void straight(PlotPen& pen, glm::dvec2 from, glm::dvec2 to, Ink ink, double width) {
    const std::array<glm::dvec2, 2> ends = {from, to};
    pen.line(ends, ink, width);
}

double hair(const PlotPen& pen) { return std::max(1.0, std::round(pen.em() / 13)); }

void stroked(PlotPen& pen, std::span<const glm::dvec2> points, const Series& series) {
    const double width = 0.13 * pen.em();
    const auto draw = [&](std::span<const glm::dvec2> piece) { pen.line(piece, series.ink, width); };
    if (points.size() < 2) return;
    switch (series.dash) {
        case Dash::solid:
            return draw(points);
        case Dash::dashed:
            return in_dashes(points, 0.6 * pen.em(), 0.4 * pen.em(), draw);
        case Dash::dotted:
            return in_dashes(points, 0.14 * pen.em(), 0.3 * pen.em(), draw);
    }
}

void draw_axes(PlotPen& pen, const PlotBox& area, const Axis& x, const Axis& y) {
    const double em = pen.em();
    for (const Tick& tick : x.ticks(static_cast<int>(area.size().x / (2.8 * em)))) {
        const double at = std::lerp(area.low.x, area.high.x, x.place(tick.value));
        straight(pen, {at, area.low.y}, {at, area.high.y}, Ink::grid, hair(pen));
        text_centred(pen, {at, area.high.y + 0.85 * em}, tick.label, Ink::quiet);
    }
    for (const Tick& tick : y.ticks(static_cast<int>(area.size().y / (2 * em)))) {
        const double at = std::lerp(area.high.y, area.low.y, y.place(tick.value));
        straight(pen, {area.low.x, at}, {area.high.x, at}, Ink::grid, hair(pen));
        text_before(pen, {area.low.x - 0.5 * em, at}, tick.label, Ink::quiet);
    }
    straight(pen, {area.low.x, area.high.y}, area.high, Ink::quiet, hair(pen));
    straight(pen, area.low, {area.low.x, area.high.y}, Ink::quiet, hair(pen));
    text_centred(pen, {0.5 * (area.low.x + area.high.x), area.high.y + 2 * em}, x.title, Ink::quiet);
}

glm::u8vec3 shade_colour(double place) { return inferno(place); }

double colour_bar_width(const PlotPen& pen, const Axis& shade) {
    double widest = 0;
    for (const Tick& tick : shade.ticks(6)) widest = std::max(widest, pen.text_width(tick.label));
    const double bar = (bar_ems + 0.5) * pen.em() + widest;
    return std::max(bar, (number_ems + 6) * pen.em());
}

void draw_colour_bar(PlotPen& pen, const PlotBox& legend, const Axis& shade) {
    const double em = pen.em();
    const PlotBox bar{{legend.low.x, legend.low.y + reading_rows * row_ems * em},
                      {legend.low.x + bar_ems * em, legend.high.y - 0.6 * em}};
    if (bar.size().y < 2 * em) return;
    std::vector<glm::dvec2> corners;
    std::vector<glm::u8vec3> colours;
    std::vector<PlotPen::Cell> cells;
    for (int i = 0; i <= bar_steps; ++i) {
        const double place = i / double(bar_steps), y = std::lerp(bar.high.y, bar.low.y, place);
        corners.insert(corners.end(), {{bar.low.x, y}, {bar.high.x, y}});
        colours.insert(colours.end(), 2, shade_colour(place));
        const auto first = static_cast<std::uint16_t>(2 * i);
        if (i > 0)
            cells.push_back({static_cast<std::uint16_t>(first - 2), static_cast<std::uint16_t>(first - 1),
                             static_cast<std::uint16_t>(first + 1), first});
    }
    pen.mesh(corners, colours, cells);
    const std::vector<Tick> ticks = shade.ticks(static_cast<int>(bar.size().y / (1.6 * em)));
    for (const Tick& tick : ticks) {
        const double y = std::lerp(bar.high.y, bar.low.y, shade.place(tick.value));
        const bool last = &tick == &ticks.back();
        pen.text({bar.high.x + 0.5 * em, y}, tick.label + (last ? " " + shade.unit : ""), Ink::quiet);
    }
}

double legend_width(const PlotPen& pen, const std::vector<Series>& series) {
    double widest = 0;
    for (const Series& one : series) widest = std::max(widest, pen.text_width(one.name));
    return (swatch_ems + 0.6 + number_ems) * pen.em() + widest;
}

void draw_legend(PlotPen& pen, const PlotBox& legend, const std::vector<Series>& series, const Axis& x,
                 const std::optional<PlotReading>& reading) {
    const double em = pen.em();
    // One row more, for the abscissa; closer where there are many.
    const double rows = static_cast<double>(series.size()) + 1;
    const double row = std::min(row_ems * em, legend.size().y / rows);
    glm::dvec2 at(legend.low.x, legend.low.y + 0.5 * row);
    if (reading) {
        pen.text({at.x + (swatch_ems + 0.6) * em, at.y}, x.title.substr(x.title.rfind(' ') + 1), Ink::quiet);
        text_before(pen, {legend.high.x, at.y}, x.text(reading->at.x), Ink::text);
    }
    for (std::size_t i = 0; i < series.size(); ++i) {
        at.y += row;
        const std::array<glm::dvec2, 2> swatch = {at, glm::dvec2(at.x + swatch_ems * em, at.y)};
        stroked(pen, swatch, series[i]);
        pen.text({at.x + (swatch_ems + 0.6) * em, at.y}, series[i].name, Ink::quiet);
        if (reading) text_before(pen, {legend.high.x, at.y}, number_text(reading->values[i]), Ink::text);
    }
}

void draw_reading(PlotPen& pen, const PlotBox& legend, const std::vector<std::string>& lines) {
    glm::dvec2 at = legend.low;
    at.y += 0.5 * row_ems * pen.em();
    for (const std::string& line : lines) {
        pen.text(at, line, Ink::text);
        at.y += row_ems * pen.em();
    }
}

std::vector<std::string> colour_lines(const std::vector<double>& rgb, const Axis& axis) {
    const dvec3 colour(rgb[0], rgb[1], rgb[2]);
    std::vector<std::string> lines = {axis.text(luminance(colour))};
    if (is_grey(colour)) return lines;
    lines.front() += ", luminance";
    lines.push_back(fmt::format("{} {} {}", number_text(rgb[0]), number_text(rgb[1]), number_text(rgb[2])));
    return lines;
}

}  // namespace nacre
