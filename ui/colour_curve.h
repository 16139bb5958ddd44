// Colours over an angle, as rows of numbers.
#pragma once

#include <cstddef>
#include <vector>

#include "core/model/kinds/parameter.h"

namespace nacre::ui {

// An angle and a colour for each point; an angle stays between those of its neighbours. Returns whether
// anything changed.
bool colour_curve_fields(std::vector<ColourPoint>& points, const ParameterText& text, Range theta_bounds,
                         std::size_t points_max);

}  // namespace nacre::ui
