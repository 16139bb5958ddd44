#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/image/luminance.h"
#include "core/model/polar_angles.h"
#include "core/paint/hemisphere_view.h"
#include "core/plot/draw_parts.h"

namespace nacre {
namespace {

constexpr int circle_steps = 72;
constexpr double reach_part = 0.04;  // of the height: within which a pointer takes a point of the shape
const dvec3 light = glm::normalize(dvec3(-0.45, 0.65, 0.8));  // in the viewer's frame

// Projects points in space onto the page.
struct Projection {
    glm::dmat3 turn;
    glm::dvec2 middle;
    double unit;  // pixels of a radius of 1

    Projection(const PlotBox& area, const ShapeView& view) : turn(to_view(view.yaw, view.pitch)) {
        const double up = std::max(turn[2].y, std::fabs(turn[2].z)), down = std::fabs(turn[2].z);
        unit = std::min(0.5 * area.size().x, area.size().y / (up + down)) * view.zoom;
        middle = 0.5 * (area.low + area.high);
        middle.y += 0.5 * (up - down) * unit;
    }

    glm::dvec2 place(dvec3 at) const {
        const dvec3 seen = turn * at;
        return {middle.x + seen.x * unit, middle.y - seen.y * unit};
    }
};

dvec3 point_of(const ShapePlot& plot, std::size_t vertex) {
    return plot.k2[vertex] * plot.radius.place(luminance(plot.values[vertex]));
}

// The cells between one ring and the next, the innermost around the first point.
std::vector<PlotPen::Cell> cells_of(const ShapePlot& plot) {
    std::vector<PlotPen::Cell> cells;
    const auto vertex = [&](int ring, int spoke) {
        return static_cast<std::uint16_t>(ring == 0 ? 0 : 1 + (ring - 1) * plot.spokes + spoke % plot.spokes);
    };
    for (int ring = 0; ring < plot.rings; ++ring)
        for (int spoke = 0; spoke < plot.spokes; ++spoke)
            cells.push_back({vertex(ring, spoke), vertex(ring + 1, spoke), vertex(ring + 1, spoke + 1),
                             vertex(ring, spoke + 1)});
    return cells;
}

// Each vertex's colour by its value, lit so that the form shows.
std::vector<glm::u8vec3> lit_colours(const ShapePlot& plot, const std::vector<dvec3>& seen,
                                     const std::vector<PlotPen::Cell>& cells) {
    std::vector<dvec3> normals(seen.size(), dvec3(0));
    for (const PlotPen::Cell& cell : cells) {
        const dvec3 normal = glm::cross(seen[cell[2]] - seen[cell[0]], seen[cell[3]] - seen[cell[1]]);
        for (const std::uint16_t corner : cell) normals[corner] += normal;
    }
    std::vector<glm::u8vec3> colours;
    for (std::size_t i = 0; i < seen.size(); ++i) {
        const double length = glm::length(normals[i]);
        const double facing = length > 0 ? std::fabs(glm::dot(normals[i], light)) / length : 1;
        const glm::u8vec3 base = shade_colour(0.3 + 0.65 * plot.radius.place(luminance(plot.values[i])));
        colours.emplace_back(glm::round(dvec3(base) * (0.45 + 0.55 * facing)));
    }
    return colours;
}

void draw_ground(PlotPen& pen, const ShapePlot& plot, const Projection& projection) {
    const auto ring = [&](double radius, Ink ink) {
        std::vector<glm::dvec2> points;
        for (int i = 0; i <= circle_steps; ++i)
            points.push_back(projection.place(polar_direction(90, 360.0 * i / circle_steps) * radius));
        pen.line(points, ink, hair(pen));
    };
    for (const Tick& tick : plot.radius.ticks(5)) ring(plot.radius.place(tick.value), Ink::grid);
    ring(1, Ink::quiet);
    for (int phi = 0; phi < 360; phi += 90) {
        straight(pen, projection.place({0, 0, 0}), projection.place(polar_direction(90, phi)), Ink::grid,
                 hair(pen));
        const char* name = phi == 0 ? "x" : phi == 90 ? "y" : "";
        text_centred(pen, projection.place(polar_direction(90, phi) * 1.07), name, Ink::quiet);
    }
    straight(pen, projection.place({0, 0, 0}), projection.place({0, 0, 1}), Ink::grid, hair(pen));
}

void draw_k1(PlotPen& pen, const ShapePlot& plot, const Projection& projection) {
    straight(pen, projection.place(plot.k1), projection.place({0, 0, 0}), Ink::text, 1.5 * hair(pen));
    pen.disc(projection.place(plot.k1), 0.32 * pen.em(), Ink::text);
}

}  // namespace

std::optional<PlotReading> read_shape(const ShapePlot& plot, const PlotLayout& layout, const ShapeView& view,
                                      glm::dvec2 pixel) {
    const Projection projection(layout.area, view);
    const double reach = reach_part * layout.area.size().y;
    std::optional<PlotReading> reading;
    double nearest = -1e9;
    for (std::size_t i = 0; i < plot.k2.size(); ++i) {
        const dvec3 at = point_of(plot, i);
        if (glm::length(projection.place(at) - pixel) > reach) continue;
        const double depth = (projection.turn * at).z;
        if (depth <= nearest) continue;
        nearest = depth;
        const dvec3& value = plot.values[i];
        reading = PlotReading{.at = {polar_angle(plot.k2[i]), azimuth(plot.k2[i])},
                              .values = {value.x, value.y, value.z},
                              .vertex = i};
    }
    return reading;
}

void draw_shape(PlotPen& pen, const ShapePlot& plot, const PlotLayout& layout, const ShapeView& view,
                const std::optional<PlotReading>& reading) {
    const Projection projection(layout.area, view);
    draw_ground(pen, plot, projection);
    const bool behind = (projection.turn * plot.k1).z < 0;
    if (behind) draw_k1(pen, plot, projection);
    std::vector<dvec3> seen;
    std::vector<glm::dvec2> corners;
    for (std::size_t i = 0; i < plot.k2.size(); ++i) {
        const dvec3 at = point_of(plot, i);
        seen.push_back(projection.turn * at);
        corners.push_back(projection.place(at));
    }
    std::vector<PlotPen::Cell> cells = cells_of(plot);
    const std::vector<glm::u8vec3> colours = lit_colours(plot, seen, cells);
    std::sort(cells.begin(), cells.end(), [&](const PlotPen::Cell& a, const PlotPen::Cell& b) {
        return seen[a[0]].z + seen[a[2]].z < seen[b[0]].z + seen[b[2]].z;
    });
    pen.mesh(corners, colours, cells);
    if (!behind) draw_k1(pen, plot, projection);
    if (reading) {
        pen.disc(corners[reading->vertex], 0.32 * pen.em(), Ink::text);
        std::vector<std::string> lines = {fmt::format("\u03b82 {:.1f}\u00b0", reading->at.x),
                                          fmt::format("\u03c62 {:.1f}\u00b0", reading->at.y)};
        for (std::string& line : colour_lines(reading->values, plot.radius)) lines.push_back(std::move(line));
        draw_reading(pen, layout.legend, lines);
    }
    draw_colour_bar(pen, layout.legend, plot.radius);
}

}  // namespace nacre
