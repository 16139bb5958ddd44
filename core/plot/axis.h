// An axis of a plot: what it spans and how its ticks read.
#pragma once

#include <string>
#include <vector>

namespace nacre {

struct Tick {
    double value;
    std::string label;
};

struct Axis {
    std::string title;
    std::string unit;  // "\u00b0", "1/sr", or nothing
    double low = 0, high = 1;
    bool logarithmic = false;

    // 0 at `low`, 1 at `high`, and clamped to them; 0 for NaN.
    double place(double value) const;
    double value(double place) const;

    // At most this many, evenly spaced: 1, 2 or 5 times a power of ten, fractions of a right angle for
    // degrees, powers of ten on a logarithmic axis.
    std::vector<Tick> ticks(int most) const;

    // "45.0\u00b0", "0.123 1/sr"
    std::string text(double value) const;
};

// Four digits at most, as one would write them: 0.0123, 1230, 1.2e-07.
std::string number_text(double value);

Axis angle_axis(std::string title, double low, double high);  // degrees

// From 0 to a round number at least as large as `highest` and `least_high`, or, logarithmic, over the decades
// down to a ten-thousandth of it.
Axis value_axis(std::string title, std::string unit, double highest, bool logarithmic, double least_high = 0);

}  // namespace nacre
