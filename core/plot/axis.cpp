#include "core/plot/axis.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace nacre {
namespace {

constexpr double decades = 4;      // below the highest value, on a logarithmic axis
constexpr double value_steps = 8;  // at most, on a linear axis from 0
constexpr const char* degree_sign = "\u00b0";

// The smallest of 1, 2 and 5 times a power of ten that is at least `value`.
double round_up(double value) {
    const double power = std::pow(10, std::floor(std::log10(value)));
    for (const double digit : {1.0, 2.0, 5.0})
        if (digit * power >= value * (1 - 1e-9)) return digit * power;
    return 10 * power;
}

double angle_step(double span, int most) {
    for (const double step : {1.0, 2.0, 5.0, 10.0, 15.0, 30.0, 45.0})
        if (span / step <= most - 1) return step;
    return 90;
}

std::vector<Tick> decade_ticks(const Axis& axis, int most) {
    const int first = static_cast<int>(std::ceil(std::log10(axis.low) - 1e-9));
    const int last = static_cast<int>(std::floor(std::log10(axis.high) + 1e-9));
    const int step = std::max(1, static_cast<int>(std::ceil((last - first + 1) / double(std::max(most, 1)))));
    std::vector<Tick> ticks;
    for (int decade = last; decade >= first; decade -= step) {
        const double value = std::pow(10, decade);
        ticks.insert(ticks.begin(), {value, number_text(value)});
    }
    return ticks;
}

}  // namespace

std::string number_text(double value) {
    if (std::fabs(value) < 1e-300) return "0";
    return fmt::format("{:.4g}", value);
}

double Axis::place(double value) const {
    if (!(value > low)) return 0;
    if (!logarithmic) return std::min((value - low) / (high - low), 1.0);
    return std::min(std::log(value / low) / std::log(high / low), 1.0);
}

double Axis::value(double place) const {
    return logarithmic ? low * std::pow(high / low, place) : low + place * (high - low);
}

std::vector<Tick> Axis::ticks(int most) const {
    if (logarithmic) return decade_ticks(*this, most);
    const bool angle = unit == degree_sign;
    const double step = angle ? angle_step(high - low, most) : round_up((high - low) / std::max(most - 1, 1));
    std::vector<Tick> ticks;
    for (double i = std::ceil(low / step - 1e-9); i * step <= high + 1e-9 * step; ++i) {
        const double value = i * step;
        ticks.push_back({value, number_text(value) + (angle ? degree_sign : "")});
    }
    return ticks;
}

std::string Axis::text(double value) const {
    if (unit == degree_sign) return fmt::format("{:.1f}{}", value, degree_sign);
    return number_text(value) + (unit.empty() ? "" : " " + unit);
}

Axis angle_axis(std::string title, double low, double high) {
    return {.title = std::move(title), .unit = degree_sign, .low = low, .high = high};
}

Axis value_axis(std::string title, std::string unit, double highest, bool logarithmic, double least_high) {
    Axis axis{.title = std::move(title), .unit = std::move(unit), .logarithmic = logarithmic};
    highest = std::clamp(highest, 1e-300, 1e300);
    if (logarithmic) {
        axis.high = std::pow(10, std::ceil(std::log10(highest) - 1e-9));
        axis.low = std::pow(10, std::floor(std::log10(highest) - decades + 1e-9));
    } else {
        const double step = round_up(highest / value_steps);
        axis.high = highest <= least_high ? least_high : step * std::ceil(highest / step - 1e-9);
    }
    return axis;
}

}  // namespace nacre
