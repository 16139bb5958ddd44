#include "ui/colour_curve.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "ui/list_buttons.h"
#include "ui/widgets.h"

namespace nacre::ui {
namespace {

constexpr double least_gap = 0.1;  // degrees, between two points

bool point_fields(std::vector<ColourPoint>& points, std::size_t i, const ParameterText& text, Range bounds) {
    const double low = i > 0 ? points[i - 1].theta + least_gap : bounds.low;
    const double high = i + 1 < points.size() ? points[i + 1].theta - least_gap : bounds.high;
    const std::string angle = fmt::format("Angle {}", i + 1), shade = fmt::format("Colour {}", i + 1);
    bool changed = false;
    if (low <= high)
        changed = slider({.label = angle.c_str(),
                          .low = low,
                          .high = high,
                          .least = low,
                          .most = high,
                          .reset = points[i].theta,
                          .format = "%.1f\u00b0",
                          .tooltip = text.tooltip},
                         points[i].theta);
    return colour(shade.c_str(), points[i].colour, glm::dvec3(1), text.tooltip) || changed;
}

// Half way from the last point to the end; at the end itself the last two make room.
ColourPoint next_point(std::vector<ColourPoint>& points, Range bounds) {
    ColourPoint& last = points.back();
    const double before = points.size() > 1 ? points[points.size() - 2].theta : bounds.low;
    if (bounds.high - last.theta >= 2 * least_gap) return {(last.theta + bounds.high) / 2, last.colour};
    const ColourPoint next{bounds.high, last.colour};
    last.theta = (before + bounds.high) / 2;
    return next;
}

}  // namespace

bool colour_curve_fields(std::vector<ColourPoint>& points, const ParameterText& text, Range theta_bounds,
                         std::size_t points_max) {
    bool changed = false;
    for (std::size_t i = 0; i < points.size(); ++i) changed |= point_fields(points, i, text, theta_bounds);
    const double before = points.size() > 1 ? points[points.size() - 2].theta : theta_bounds.low - 1;
    const bool has_room = theta_bounds.high - before >= 3 * least_gap;
    changed |= list_buttons(points, 1, has_room ? points_max : points.size(), text, "point",
                            [&] { return next_point(points, theta_bounds); });
    return changed;
}

}  // namespace nacre::ui
