// A logarithmic axis: what it spans and how its ticks read.
#pragma once

#include <cmath>
#include <string>
#include <vector>

namespace nacre {

// How the numbers at an axis read: 10 ms, 1 % or 0.01.
enum class ChartUnit { seconds, percent, parts };

// Of a power of ten: "100 µs" for -4.
std::string tick_label(ChartUnit unit, int decade);

// In decades.
struct LogRange {
    double low = 0, high = 1;
    double place(double value) const { return (std::log10(value) - low) / (high - low); }
    int first_tick() const { return static_cast<int>(std::ceil(low - 1e-9)); }
    int last_tick() const { return static_cast<int>(std::floor(high + 1e-9)); }
};

LogRange range_of(const std::vector<double>& values);  // all above 0

LogRange whole_decades(LogRange range);  // at least one

// At least a decade, and room for the marks at both ends.
LogRange with_margin(LogRange range);

}  // namespace nacre
