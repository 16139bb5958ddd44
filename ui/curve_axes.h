// The plane on which p(theta) is drawn: which angle and which value stand where.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "core/design/design.h"

namespace nacre::ui {

using CurvePoints = std::vector<std::pair<double, double>>;  // as in CurveLobe

// Heights are linear, or logarithmic above `least` with a strip below it in which they go down to 0 linearly:
// so a value of 0 has its place, and each height its value.
struct CurveAxes {
    double angle_end = 90;  // degrees
    double top = 1;         // value at height 1
    double least = 0;       // where the strip ends; 0 for linear heights

    bool logarithmic() const { return least > 0; }
    double height(double value) const;  // in [0, 1]; what lies outside stands at the end
    double value(double height) const;  // its inverse
    std::vector<double> marks() const;  // values worth a line, from below: decades or round steps; no 0
    bool operator==(const CurveAxes&) const = default;
};

inline constexpr double strip_height = 0.12;  // of the strip for values below `least`

// Axes on which all values of the points are seen, with room above the highest; logarithmic ones hold at
// least four decades, and at most nine. Beyond a chosen end of 90 degrees the angles go to 180 where points
// do.
CurveAxes axes_for(const CurvePoints& points, bool logarithmic, double angle_end);

// The number that is written with three digits: 0.3 and not 0.30000000000000004.
double three_digits(double value);

// p at an angle: straight lines between the points, 0 outside them.
double curve_value(const CurvePoints& points, double angle);

// The angles between which a point may move; the least is above the most where its neighbours leave no room.
std::pair<double, double> angle_room(const CurvePoints& points, std::size_t index);

// Moves a point, between its neighbours and within what a design may hold. Where the neighbours leave no room
// its angle stays.
void set_point(CurvePoints& points, std::size_t index, std::pair<double, double> to);

// Adds a point in its place and returns its index; nothing where there is no room for one more.
std::optional<std::size_t> add_point(CurvePoints& points, std::pair<double, double> point);

// A curve keeps at least two points. Returns whether one is gone.
bool remove_point(CurvePoints& points, std::size_t index);

}  // namespace nacre::ui
