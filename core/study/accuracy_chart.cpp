#include "core/study/accuracy_chart.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <sstream>

#include "core/base/error.h"

namespace nacre {
namespace {

std::vector<std::string> words_of(const std::string& text) {
    std::vector<std::string> words;
    std::istringstream stream(text);
    for (std::string word; stream >> word;) words.push_back(word);
    return words;
}

// "degree 2" and "degree 64" become "degree 2 to 64", "16 samples" and "64 samples" "16 to 64 samples".
std::string span_of(const std::string& first, const std::string& last) {
    std::vector<std::string> a = words_of(first), b = words_of(last);
    if (a == b) return first;
    while (!a.empty() && !b.empty() && a.back() == b.back()) {
        a.pop_back();
        b.pop_back();
    }
    const std::vector<std::string> all = words_of(last);
    std::size_t shared = 0;
    while (shared < a.size() && shared < b.size() && a[shared] == b[shared]) ++shared;
    return fmt::format("{} to {}", fmt::join(a, " "),
                       fmt::join(all.begin() + static_cast<long>(shared), all.end(), " "));
}

Ink ink_of(MethodKind kind) {
    switch (kind) {
        case MethodKind::monte_carlo:
            return Ink::first;
        case MethodKind::cubature:
            return Ink::second;
        case MethodKind::plain_grid:
            return Ink::third;
        case MethodKind::stretched:
            return Ink::red;
        case MethodKind::bake:
            return Ink::plain;
        case MethodKind::harmonics:
            return Ink::fourth;
    }
    return Ink::plain;
}

PointSeries series_of(const MethodAccuracy& method, ChartOf quantity) {
    PointSeries line{.name = method.name, .ink = ink_of(method.kind)};
    const double error_unit = quantity == ChartOf::area ? 0.01 : 1, time_unit = 1e-3;
    const std::vector<ShownPoint> points = shown_points(method, quantity);
    // The bake's own choices are not a series, and are labelled by name.
    const bool by_name = method.kind == MethodKind::bake;
    line.joined = !by_name;
    for (const ShownPoint& point : points) {
        const double time = point.seconds / time_unit;
        line.points.emplace_back(time, point.error.worst / error_unit);
        if (by_name)
            line.labels.push_back(point.setting);
        else
            line.thin_points.emplace_back(time, point.error.root_mean_square / error_unit);
    }
    if (!points.empty())
        line.note = by_name ? "as it comes, in two qualities"
                            : span_of(points.front().setting, points.back().setting);
    else
        line.note = method.left_out.empty() ? "" : "left out: " + method.left_out;
    return line;
}

}  // namespace

PointPlot accuracy_chart(const DesignAccuracy& design, ChartOf quantity) {
    const bool area = quantity == ChartOf::area;
    PointPlot chart;
    chart.title = design.name.empty() ? design.file : one_line(design.name, 60);
    chart.subtitle = area ? "Projected area g: error of the table against the time to make it"
                          : "Albedo R: error of the table against the time to make it";
    chart.x.title = "time from the design to the finished table, one thread (ms)";
    chart.y.title = area ? "worst relative error of g (%)" : "worst error of R, which lies between 0 and 1";
    for (const MethodAccuracy& method : design.methods) {
        PointSeries line = series_of(method, quantity);
        if (!line.points.empty() || (area && !method.left_out.empty()))
            chart.series.push_back(std::move(line));
    }
    int directions = 0;
    for (const MethodAccuracy& method : design.methods)
        for (const ShownPoint& point : shown_points(method, quantity)) directions = point.error.directions;
    chart.notes = {
        area
            ? fmt::format("Thick: worst of {} directions from the normal to grazing. Thin: root mean square.",
                          directions)
            : fmt::format(
                  "Thick: worst of {} directions from the normal to grazing, with F = 1 and with Schlick's "
                  "factor of f0 = 0. Thin: root mean square. The time is that of g and R together.",
                  directions / 2),
        "What is above the chart is cut off; what is below stands at its foot."};
    fit_axes(chart, area ? 1e-4 : 1e-6, area ? 100 : 1);
    return chart;
}

std::string chart_file(const std::string& stem, ChartOf quantity) {
    return stem + (quantity == ChartOf::area ? "-g.svg" : "-R.svg");
}

}  // namespace nacre
