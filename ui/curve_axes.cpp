#include "ui/curve_axes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace nacre::ui {
namespace {

constexpr double angle_max = 180;                // degrees
constexpr double angle_gap = 0.01;               // degrees between neighbours
constexpr double headroom = 1.25;                // above the highest point; ...
constexpr double log_headroom = 2;               // ... on logarithmic heights
constexpr int decades_min = 4, decades_max = 8;  // below the highest point's own
constexpr int marks_max = 10;
constexpr std::size_t points_min = 2;

double decade_below(double value) { return std::pow(10, std::floor(std::log10(value))); }

// 1, 2 or 5 times a power of ten, so that about four steps make `range`.
double round_step(double range) {
    const double decade = decade_below(range / 4), part = range / 4 / decade;
    return decade * (part < 1.5 ? 1 : part < 3.5 ? 2 : part < 7.5 ? 5 : 10);
}

}  // namespace

double CurveAxes::height(double value) const {
    if (!logarithmic()) return std::clamp(value / top, 0.0, 1.0);
    if (value < least) return strip_height * std::max(value, 0.0) / least;
    return std::min(strip_height + (1 - strip_height) * std::log(value / least) / std::log(top / least), 1.0);
}

double CurveAxes::value(double height) const {
    if (!logarithmic()) return height * top;
    if (height < strip_height) return height / strip_height * least;
    return least * std::pow(top / least, (height - strip_height) / (1 - strip_height));
}

std::vector<double> CurveAxes::marks() const {
    std::vector<double> values;
    const double step = round_step(top);
    for (int i = 0; i < marks_max; ++i) {
        const double value = logarithmic() ? least * std::pow(10, i) : step * (i + 1);
        if (value < top) values.push_back(value);
    }
    return values;
}

CurveAxes axes_for(const CurvePoints& points, bool logarithmic, double angle_end) {
    double highest = 0, lowest = HUGE_VAL;
    for (const auto& [angle, value] : points) {
        highest = std::max(highest, value);
        if (value > 0) lowest = std::min(lowest, value);
    }
    CurveAxes axes;
    axes.angle_end = angle_end == 90 && !points.empty() && points.back().first > 90 ? angle_max : angle_end;
    if (highest <= 0) highest = lowest = 1;
    axes.top = highest * (logarithmic ? log_headroom : headroom);
    if (!logarithmic) return axes;
    const double decade = decade_below(highest);
    axes.least = std::max(std::min(decade_below(lowest), decade * std::pow(10, -decades_min)),
                          decade * std::pow(10, -decades_max));
    return axes;
}

double three_digits(double value) { return std::strtod(fmt::format("{:.3g}", value).c_str(), nullptr); }

double curve_value(const CurvePoints& points, double angle) {
    if (points.empty() || angle < points.front().first || angle > points.back().first) return 0;
    const auto after = std::upper_bound(points.begin(), points.end(), angle,
                                        [](double a, const auto& point) { return a < point.first; });
    if (after == points.end()) return points.back().second;
    const auto before = after - 1;
    const double t = (angle - before->first) / (after->first - before->first);
    return before->second * (1 - t) + after->second * t;
}

std::pair<double, double> angle_room(const CurvePoints& points, std::size_t index) {
    return {index == 0 ? 0 : points[index - 1].first + angle_gap,
            index + 1 == points.size() ? angle_max : points[index + 1].first - angle_gap};
}

void set_point(CurvePoints& points, std::size_t index, std::pair<double, double> to) {
    const auto [least, most] = angle_room(points, index);
    if (least <= most) points[index].first = std::clamp(to.first, least, most);
    points[index].second = std::clamp(to.second, 0.0, limits::weight_max);
}

std::optional<std::size_t> add_point(CurvePoints& points, std::pair<double, double> point) {
    if (points.size() >= std::size_t{limits::curve_points_max}) return {};
    const auto after = std::upper_bound(points.begin(), points.end(), point);
    const double least = after == points.begin() ? 0 : (after - 1)->first + angle_gap;
    const double most = after == points.end() ? angle_max : after->first - angle_gap;
    if (least > most) return {};
    const auto index = static_cast<std::size_t>(after - points.begin());
    points.insert(after, point);
    set_point(points, index, point);
    return index;
}

bool remove_point(CurvePoints& points, std::size_t index) {
    if (points.size() <= points_min || index >= points.size()) return false;
    points.erase(points.begin() + static_cast<std::ptrdiff_t>(index));
    return true;
}

}  // namespace nacre::ui
