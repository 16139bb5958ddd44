#include "ui/curve_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "ui/theme.h"

namespace nacre::ui {
namespace {

constexpr float floor_reach = 4;    // pixels above the floor that mean 0
constexpr float label_size = 0.8f;  // of the text's size

float scale() { return ImGui::GetFontSize() / 15; }

void label(ImVec2 at, ImVec2 aligned, const std::string& text) {
    const float size = ImGui::GetFontSize() * label_size;
    const ImVec2 extent = ImGui::GetFont()->CalcTextSizeA(size, FLT_MAX, 0, text.c_str());
    ImGui::GetWindowDrawList()->AddText(
        ImGui::GetFont(), size,
        {std::round(at.x - aligned.x * extent.x), std::round(at.y - aligned.y * extent.y)},
        ImGui::GetColorU32(palette::text_dim), text.c_str());
}

double angle_step(double end) { return end <= 10 ? 2 : end <= 30 ? 10 : end <= 90 ? 30 : 60; }

void draw_axes(const CurvePlot& plot) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImU32 line = ImGui::GetColorU32(palette::line);
    list.AddRectFilled(plot.low, plot.high, ImGui::GetColorU32(palette::canvas));
    if (plot.axes.logarithmic())
        list.AddRectFilled({plot.low.x, plot.at(0, plot.axes.least).y}, plot.high,
                           ImGui::GetColorU32(ImVec4(1, 1, 1, 0.06f)));
    const double step = angle_step(plot.axes.angle_end);
    for (double angle = 0; angle <= plot.axes.angle_end; angle += step) {
        const float x = plot.at(angle, 0).x;
        if (angle > 0 && angle < plot.axes.angle_end) list.AddLine({x, plot.low.y}, {x, plot.high.y}, line);
        const float aligned = angle <= 0 ? 0 : angle >= plot.axes.angle_end ? 1 : 0.5f;
        label({x, plot.high.y + 3 * scale()}, {aligned, 0}, fmt::format("{:g}\u00b0", angle));
    }
    const float gap = 4 * scale();
    for (const double value : plot.axes.marks()) {
        const float y = plot.at(0, value).y;
        list.AddLine({plot.low.x, y}, {plot.high.x, y}, line);
        label({plot.low.x - gap, y}, {1, 0.5f}, short_number(value));
    }
    // The floor: p is 0 there, on either kind of height.
    list.AddLine({plot.low.x, plot.high.y}, plot.high, ImGui::GetColorU32(palette::text_dim), 1.5f * scale());
    label({plot.low.x - gap, plot.high.y}, {1, 0.5f}, "0");
}

// A pixel column each, since straight lines of p are none on logarithmic heights; and the points themselves.
std::vector<ImVec2> outline(const CurvePlot& plot, const CurvePoints& points) {
    std::vector<ImVec2> line;
    for (std::size_t i = 0; i < points.size() && points[i].first <= plot.axes.angle_end; ++i) {
        line.push_back(plot.at(points[i].first, points[i].second));
        const double end =
            i + 1 < points.size() ? std::min(points[i + 1].first, plot.axes.angle_end) : points[i].first;
        const float last = plot.at(end, 0).x;
        for (float x = std::floor(line.back().x) + 1; x < last; ++x)
            line.push_back(plot.at(plot.angle_at(x), curve_value(points, plot.angle_at(x))));
        if (end >= plot.axes.angle_end) line.push_back(plot.at(end, curve_value(points, end)));
    }
    return line;
}

void draw_line(const CurvePlot& plot, const std::vector<ImVec2>& line) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    ImVec4 under = palette::accent;
    under.w = 0.13f;
    list.Flags &= ~ImDrawListFlags_AntiAliasedFill;  // soft edges would show as seams
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
        list.AddQuadFilled(line[i], line[i + 1], {line[i + 1].x, plot.high.y}, {line[i].x, plot.high.y},
                           ImGui::GetColorU32(under));
    list.Flags |= ImDrawListFlags_AntiAliasedFill;
    list.AddPolyline(line.data(), static_cast<int>(line.size()), ImGui::GetColorU32(palette::accent), 0,
                     2 * scale());
}

// Hollow where p is 0.
void draw_point(ImVec2 at, bool zero, bool marked) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float radius = (marked ? 6 : 4) * scale();
    const ImU32 ink = ImGui::GetColorU32(marked ? palette::accent_bright : palette::text);
    list.AddCircleFilled(at, radius, zero ? ImGui::GetColorU32(palette::canvas) : ink);
    list.AddCircle(at, radius, zero ? ink : IM_COL32(0, 0, 0, 120), 0, 1.5f * scale());
}

}  // namespace

ImVec2 CurvePlot::at(double angle, double value) const {
    return {low.x + static_cast<float>(angle / axes.angle_end) * (high.x - low.x),
            high.y - static_cast<float>(axes.height(value)) * (high.y - low.y)};
}

double CurvePlot::angle_at(float x) const {
    return std::clamp(static_cast<double>((x - low.x) / (high.x - low.x)), 0.0, 1.0) * axes.angle_end;
}

double CurvePlot::value_at(float y) const {
    if (y > high.y - floor_reach * scale()) return 0;
    return axes.value(std::clamp(static_cast<double>((high.y - y) / (high.y - low.y)), 0.0, 1.0));
}

bool CurvePlot::contains(ImVec2 pixel) const {
    const float reach = floor_reach * scale();
    return pixel.x >= low.x - reach && pixel.x <= high.x + reach && pixel.y >= low.y - reach &&
           pixel.y <= high.y + reach;
}

void draw_curve(const CurvePlot& plot, const CurvePoints& points, std::optional<std::size_t> marked) {
    draw_axes(plot);
    draw_line(plot, outline(plot, points));
    for (std::size_t i = 0; i < points.size(); ++i)
        if (points[i].first <= plot.axes.angle_end)
            draw_point(plot.at(points[i].first, points[i].second), points[i].second <= 0, marked == i);
}

void draw_curve_reading(const CurvePlot& plot, double angle, double value) {
    label({plot.high.x - 5 * scale(), plot.low.y + 4 * scale()}, {1, 0},
          fmt::format("\u03b8 {:.4g}\u00b0   {:.3g}", angle, value));
}

std::string short_number(double value) {
    const double exponent = std::log10(value);
    if (value > 0 && (exponent < -2.5 || exponent > 3.5) && std::abs(exponent - std::round(exponent)) < 1e-6)
        return fmt::format("1e{:.0f}", exponent);
    return fmt::format("{:.3g}", value);
}

}  // namespace nacre::ui
