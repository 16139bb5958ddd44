// The picture of a curve.
#pragma once

#include <imgui.h>

#include <optional>
#include <string>

#include "ui/curve_axes.h"

namespace nacre::ui {

// Where the plot lies on the screen.
struct CurvePlot {
    ImVec2 low, high;  // left top, right bottom, of the axes
    CurveAxes axes;

    ImVec2 at(double angle, double value) const;
    double angle_at(float x) const;
    double value_at(float y) const;  // exactly 0 about the floor
    bool contains(ImVec2 pixel) const;
};

// `marked`: the point that is pointed at or chosen.
void draw_curve(const CurvePlot& plot, const CurvePoints& points, std::optional<std::size_t> marked);

// Numbers in the plot's right top corner.
void draw_curve_reading(const CurvePlot& plot, double angle, double value);

// "0.01", "1e-4": of a few letters.
std::string short_number(double value);

}  // namespace nacre::ui
