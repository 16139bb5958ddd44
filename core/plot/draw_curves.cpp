#include <algorithm>
#include <cmath>

#include "core/model/polar_angles.h"
#include "core/plot/draw_parts.h"

namespace nacre {
namespace {

constexpr int rim_steps = 90;

}  // namespace

void draw_curves(PlotPen& pen, const CurvePlot& plot, const PlotLayout& layout,
                 const std::optional<PlotReading>& reading) {
    const PlotBox& area = layout.area;
    draw_axes(pen, area, plot.x, plot.y);
    const auto place = [&](double x, double y) {
        return glm::dvec2(std::lerp(area.low.x, area.high.x, plot.x.place(x)),
                          std::lerp(area.high.y, area.low.y, plot.y.place(y)));
    };
    if (reading) {
        const double x = place(reading->at.x, 0).x;
        straight(pen, {x, area.low.y}, {x, area.high.y}, Ink::text, hair(pen));
    }
    for (const Series& series : plot.series) {
        std::vector<glm::dvec2> points;
        for (std::size_t i = 0; i < plot.at.size(); ++i)
            points.push_back(place(plot.at[i], series.values[i]));
        stroked(pen, points, series);
    }
    for (std::size_t i = 0; reading && i < plot.series.size(); ++i)
        pen.disc(place(reading->at.x, reading->values[i]), 0.28 * pen.em(), plot.series[i].ink);
    draw_legend(pen, layout.legend, plot.series, plot.x, reading);
}

glm::dvec2 HalfDisk::at(double angle, double place) const {
    const glm::dvec3 way = polar_direction(angle, 0);
    return middle + glm::dvec2(way.x, -way.z) * (radius * place);
}

HalfDisk half_disk(const PlotBox& area) {
    const double radius = std::max(std::min(0.5 * area.size().x, area.size().y), 1.0);
    return {.middle = {0.5 * (area.low.x + area.high.x), area.high.y}, .radius = radius};
}

double lobe_angle(const PlotLayout& layout, glm::dvec2 pixel) {
    const HalfDisk disk = half_disk(layout.area);
    const glm::dvec2 off = pixel - disk.middle;
    return std::clamp(std::atan2(off.x, -off.y) * (180 / std::numbers::pi), -90.0, 90.0);
}

namespace {

// The ends of the half disk, rings of the values and spokes of the angles.
void draw_polar_grid(PlotPen& pen, const LobePlot& plot, const HalfDisk& disk) {
    const double em = pen.em();
    const auto ring = [&](double place, Ink ink) {
        std::vector<glm::dvec2> points;
        for (int i = 0; i <= rim_steps; ++i) points.push_back(disk.at(-90 + 180.0 * i / rim_steps, place));
        pen.line(points, ink, hair(pen));
    };
    double last = -1e9;
    for (const Tick& tick : plot.curves.y.ticks(static_cast<int>(disk.radius / (2.5 * em)))) {
        const double place = plot.curves.y.place(tick.value);
        ring(place, Ink::grid);
        // Below the horizon, where no lobe stands, as far as the numbers have room.
        const double half = 0.5 * pen.text_width(tick.label), x = disk.middle.x + place * disk.radius;
        if (x - half < last) continue;
        text_centred(pen, {x, disk.middle.y + 0.85 * em}, tick.label, Ink::quiet);
        last = x + half + 0.5 * em;
    }
    ring(1, Ink::quiet);
    straight(pen, disk.at(-90, 1), disk.at(90, 1), Ink::quiet, hair(pen));
    for (int angle = -90; angle <= 90; angle += 30) {
        if (std::abs(angle) < 90) straight(pen, disk.middle, disk.at(angle, 1), Ink::grid, hair(pen));
        const glm::dvec2 out = disk.at(angle, 1 + 0.8 * em / disk.radius);
        const std::string text = std::to_string(std::abs(angle)) + "\u00b0";
        const double lift = std::abs(angle) == 90 ? -0.3 * em : 0;
        if (angle < 0)
            text_before(pen, {out.x, out.y + lift}, text, Ink::quiet);
        else if (angle > 0)
            pen.text({out.x, out.y + lift}, text, Ink::quiet);
        else
            text_centred(pen, out, text, Ink::quiet);
    }
}

}  // namespace

void draw_lobe(PlotPen& pen, const LobePlot& plot, const PlotLayout& layout,
               const std::optional<PlotReading>& reading) {
    const HalfDisk disk = half_disk(layout.area);
    const double em = pen.em();
    draw_polar_grid(pen, plot, disk);
    straight(pen, disk.at(-plot.incidence, 1), disk.middle, Ink::text, 1.5 * hair(pen));
    pen.disc(disk.at(-plot.incidence, 1), 0.32 * em, Ink::text);
    const std::array<glm::dvec2, 2> mirror = {disk.middle, disk.at(plot.incidence, 1)};
    stroked(pen, mirror, {.name = "mirror", .ink = Ink::quiet, .dash = Dash::dotted});
    if (reading) straight(pen, disk.middle, disk.at(reading->at.x, 1), Ink::text, hair(pen));
    for (const Series& series : plot.curves.series) {
        std::vector<glm::dvec2> points = {disk.middle};
        for (std::size_t i = 0; i < plot.curves.at.size(); ++i)
            points.push_back(disk.at(plot.curves.at[i], plot.curves.y.place(series.values[i])));
        points.push_back(disk.middle);
        stroked(pen, points, series);
    }
    for (std::size_t i = 0; reading && i < plot.curves.series.size(); ++i)
        pen.disc(disk.at(reading->at.x, plot.curves.y.place(reading->values[i])), 0.28 * em,
                 plot.curves.series[i].ink);
    draw_legend(pen, layout.legend, plot.curves.series, plot.curves.x, reading);
}

}  // namespace nacre
