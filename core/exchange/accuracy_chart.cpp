#include "core/exchange/accuracy_chart.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <sstream>

#include "core/design/error.h"

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

ChartLine line_of(const WayAccuracy& way, ChartOf quantity) {
    ChartLine line{.name = way.name};
    const std::vector<ShownPoint> points = shown_points(way, quantity);
    // The bake's own choices are no series, and stand by name.
    const bool by_name = way.kind == WayKind::bake;
    line.joined = !by_name;
    for (const ShownPoint& point : points) {
        line.points.push_back({point.seconds, point.error.worst, by_name ? point.setting : ""});
        if (!by_name) line.faint.push_back({point.seconds, point.error.root_mean_square});
    }
    if (!points.empty())
        line.note = by_name ? "as it comes, in two qualities"
                            : span_of(points.front().setting, points.back().setting);
    else
        line.note = way.left_out.empty() ? "" : "left out: " + way.left_out;
    return line;
}

}  // namespace

LogChart accuracy_chart(const DesignAccuracy& design, ChartOf quantity) {
    const bool area = quantity == ChartOf::area;
    LogChart chart;
    chart.title = design.name.empty() ? design.file : one_line(design.name, 60);
    chart.subtitle =
        area ? "Projected area g: how far the table is from the truth, and how long it takes to make"
             : "Albedo R: how far the table is from the truth, and how long it takes to make";
    chart.x = {"time from the design to the finished table, one thread", ChartUnit::seconds};
    chart.y = area ? ChartAxis{"worst relative error of g", ChartUnit::percent}
                   : ChartAxis{"worst error of R, which lies between 0 and 1", ChartUnit::parts};
    for (const WayAccuracy& way : design.ways) {
        ChartLine line = line_of(way, quantity);
        if (!line.points.empty() || (area && !way.left_out.empty())) chart.lines.push_back(std::move(line));
    }
    int directions = 0;
    for (const WayAccuracy& way : design.ways)
        for (const ShownPoint& point : shown_points(way, quantity)) directions = point.error.directions;
    chart.notes = {
        area ? fmt::format(
                   "Solid: worst of {} directions from the normal to grazing. Dotted: root mean square.",
                   directions)
             : fmt::format(
                   "Solid: worst of {} directions from the normal to grazing, with F = 1 and with Schlick's "
                   "factor of f0 = 0. Dotted: root mean square. The time is that of g and R together.",
                   directions / 2),
        "What is above the chart is cut off; what is below stands at its foot."};
    return chart;
}

std::string chart_file(const std::string& stem, ChartOf quantity) {
    return stem + (quantity == ChartOf::area ? "-g.svg" : "-R.svg");
}

}  // namespace nacre
