#include "ui/curve_editor.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "ui/item_map.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace nacre::ui {
namespace {

using Points = std::vector<std::pair<double, double>>;

constexpr double angle_most = 180;  // degrees
constexpr double angle_gap = 0.01;  // degrees between neighbours
constexpr double value_most = 1e6;
constexpr float reach = 8;  // pixels within which a press takes a point
constexpr std::size_t points_least = 2;

// Where the plot lies on the screen and what it spans.
struct Plot {
    ImVec2 low, high;  // left top, right bottom
    double angle_end, value_end;

    ImVec2 at(std::pair<double, double> point) const {
        return {low.x + static_cast<float>(point.first / angle_end) * (high.x - low.x),
                high.y - static_cast<float>(point.second / value_end) * (high.y - low.y)};
    }
    std::pair<double, double> under(ImVec2 pixel) const {
        return {std::clamp(static_cast<double>((pixel.x - low.x) / (high.x - low.x)), 0.0, 1.0) * angle_end,
                std::clamp(static_cast<double>((high.y - pixel.y) / (high.y - low.y)), 0.0, 1.0) * value_end};
    }
};

double rounded(double value, double step) { return std::round(value / step) * step; }

// A little room above the highest point, and the same for all heights within a factor of two: the plot
// must not move under the pointer while a point is dragged inside it.
double value_end(const Points& points) {
    double highest = 0;
    for (const auto& point : points) highest = std::max(highest, point.second);
    if (highest <= 0) return 1;
    return std::exp2(std::ceil(std::log2(highest))) * 1.05;
}

void set_point(Points& points, std::size_t index, std::pair<double, double> to) {
    const double least = index == 0 ? 0 : points[index - 1].first + angle_gap;
    const double most = index + 1 == points.size() ? angle_most : points[index + 1].first - angle_gap;
    points[index] = {std::clamp(to.first, least, std::max(least, most)),
                     std::clamp(to.second, 0.0, value_most)};
}

void draw_plot(const Plot& plot, const Points& points, std::size_t marked) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float scale = ImGui::GetFontSize() / 15;
    list.AddRectFilled(plot.low, plot.high, ImGui::GetColorU32(palette::canvas), 4);
    for (double angle = 30; angle < plot.angle_end; angle += 30) {
        const float x = plot.at({angle, 0}).x;
        list.AddLine({x, plot.low.y}, {x, plot.high.y}, ImGui::GetColorU32(palette::line));
        list.AddText(ImGui::GetFont(), ImGui::GetFontSize() * 0.8f,
                     {x + 3, plot.high.y - ImGui::GetFontSize()}, ImGui::GetColorU32(palette::text_dim),
                     (std::to_string(int(angle)) + "\u00b0").c_str());
    }
    std::vector<ImVec2> line;
    for (const auto& point : points) line.push_back(plot.at(point));
    list.AddPolyline(line.data(), static_cast<int>(line.size()), ImGui::GetColorU32(palette::accent), 0,
                     2 * scale);
    for (std::size_t i = 0; i < line.size(); ++i)
        list.AddCircleFilled(line[i], (i == marked ? 6 : 4) * scale,
                             ImGui::GetColorU32(i == marked ? palette::accent_bright : palette::text));
}

std::size_t point_near(const Plot& plot, const Points& points, ImVec2 pixel) {
    std::size_t best = points.size();
    float nearest = std::pow(reach * ImGui::GetFontSize() / 15, 2.0f);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const ImVec2 at = plot.at(points[i]);
        const float squared = (at.x - pixel.x) * (at.x - pixel.x) + (at.y - pixel.y) * (at.y - pixel.y);
        if (squared <= nearest) nearest = squared, best = i;
    }
    return best;
}

bool add_point(Points& points, std::pair<double, double> point) {
    if (points.size() >= limits::curve_points_max) return false;
    const auto after = std::upper_bound(points.begin(), points.end(), point);
    const auto index = static_cast<std::size_t>(after - points.begin());
    points.insert(after, point);
    set_point(points, index, point);
    return true;
}

// Press, drag and clicks on the plot. The dragged point's index lives in the window's own storage.
bool handle_mouse(const Plot& plot, Points& points, std::size_t near) {
    ImGuiStorage& storage = *ImGui::GetStateStorage();
    const ImGuiID key = ImGui::GetID("dragged");
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const bool on_point = near < points.size();
    if (ImGui::IsItemActivated()) storage.SetInt(key, on_point ? static_cast<int>(near) : -1);
    if (ImGui::IsItemHovered()) {
        if (on_point && points.size() > points_least && ImGui::IsMouseClicked(ImGuiMouseButton_Right)) {
            points.erase(points.begin() + static_cast<std::ptrdiff_t>(near));
            return true;
        }
        if (!on_point && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
            const auto [angle, value] = plot.under(mouse);
            return add_point(points, {rounded(angle, 0.1), rounded(value, plot.value_end / 1000)});
        }
    }
    const int dragged = storage.GetInt(key, -1);
    if (!ImGui::IsItemActive() || dragged < 0 || dragged >= static_cast<int>(points.size()) ||
        !ImGui::IsMouseDragging(ImGuiMouseButton_Left, 1))
        return false;
    const Points before = points;
    const auto [angle, value] = plot.under(mouse);
    set_point(points, static_cast<std::size_t>(dragged), {rounded(angle, 0.1), value});
    return points != before;
}

bool point_numbers(Points& points) {
    bool changed = false;
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const float width = (ImGui::GetContentRegionAvail().x - ImGui::GetFrameHeight() - 2 * gap) / 2;
    for (std::size_t i = 0; i < points.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        auto point = points[i];
        ImGui::SetNextItemWidth(width);
        bool edited = ImGui::InputDouble("##angle", &point.first, 0, 0, "%.2f\u00b0");
        ImGui::SameLine(0, gap);
        ImGui::SetNextItemWidth(width);
        edited |= ImGui::InputDouble("##value", &point.second, 0, 0, "%.4g");
        ImGui::SameLine(0, gap);
        if (edited && std::isfinite(point.first) && std::isfinite(point.second)) {
            set_point(points, i, point);
            changed = true;
        }
        ImGui::BeginDisabled(points.size() <= points_least);
        const bool removed = ImGui::Button("\u00d7", ImVec2(ImGui::GetFrameHeight(), 0));
        ImGui::EndDisabled();
        ImGui::PopID();
        if (removed) {
            points.erase(points.begin() + static_cast<std::ptrdiff_t>(i));
            return true;
        }
    }
    return changed;
}

}  // namespace

bool curve_editor(CurveLobe& curve) {
    Points& points = curve.points;
    ImGui::PushID("curve");
    const ImVec2 size(ImGui::GetContentRegionAvail().x, ImGui::GetFontSize() * 9);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::InvisibleButton("plot", size);
    note_item("Curve");
    const double last = points.empty() ? 0 : points.back().first;
    const float border = ImGui::GetFontSize() * 0.5f;
    const Plot plot{.low = {corner.x + border, corner.y + border},
                    .high = {corner.x + size.x - border, corner.y + size.y - border},
                    .angle_end = last > 90 ? 180.0 : 90.0,
                    .value_end = value_end(points)};
    const std::size_t near =
        ImGui::IsItemHovered() ? point_near(plot, points, ImGui::GetIO().MousePos) : points.size();
    tooltip_for_item(
        "p over the angle from the lobe's axis. Drag a point; double click adds one, a right click on a "
        "point removes it.");
    bool changed = handle_mouse(plot, points, near);
    draw_plot(plot, points, near);
    changed |= point_numbers(points);
    ImGui::PopID();
    return changed;
}

}  // namespace nacre::ui
