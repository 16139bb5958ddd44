#include "ui/curve_editor.h"

#include <cmath>
#include <string>

#include "ui/curve_plot.h"
#include "ui/curve_shapes.h"
#include "ui/item_map.h"
#include "ui/keys.h"
#include "ui/slider_bar.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace nacre::ui {
namespace {

constexpr float reach = 8;      // pixels within which a press takes a point
constexpr float plot_ems = 11;  // height, in text sizes
constexpr double angle_ends[] = {10, 30, 90, 180};

std::optional<std::size_t> point_near(const CurvePlot& plot, const CurvePoints& points, ImVec2 pixel) {
    std::optional<std::size_t> best;
    float nearest = std::pow(reach * ImGui::GetFontSize() / 15, 2.0f);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const ImVec2 at = plot.at(points[i].first, points[i].second);
        const float squared = (at.x - pixel.x) * (at.x - pixel.x) + (at.y - pixel.y) * (at.y - pixel.y);
        if (squared <= nearest) nearest = squared, best = i;
    }
    return best;
}

// In steps that a hand can tell apart.
std::pair<double, double> point_at(const CurvePlot& plot, ImVec2 pixel) {
    const double steps = plot.axes.angle_end <= 30 ? 100 : 10;  // in a degree
    return {std::round(plot.angle_at(pixel.x) * steps) / steps, three_digits(plot.value_at(pixel.y))};
}

// The last item is the plot. A press takes the point that is near, or adds one.
bool press(CurveView& view, const CurvePlot& plot, CurvePoints& points, std::optional<std::size_t> near) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const bool adds = !near && plot.contains(mouse);
    view.chosen = adds ? add_point(points, point_at(plot, mouse)) : near;
    if (!view.chosen) return false;
    const ImVec2 at = plot.at(points[*view.chosen].first, points[*view.chosen].second);
    view.held = {.axes = plot.axes, .offset = {at.x - mouse.x, at.y - mouse.y}};
    return adds;
}

bool drag(const CurveView& view, const CurvePlot& plot, CurvePoints& points) {
    if (!ImGui::IsMouseDragging(ImGuiMouseButton_Left, 1)) return false;
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const auto before = points[*view.chosen];
    set_point(points, *view.chosen,
              point_at(plot, {mouse.x + view.held->offset.x, mouse.y + view.held->offset.y}));
    return points[*view.chosen] != before;
}

bool handle_mouse(CurveView& view, const CurvePlot& plot, CurvePoints& points,
                  std::optional<std::size_t> near) {
    if (!ImGui::IsItemActive()) view.held.reset();
    if (ImGui::IsItemActivated()) return press(view, plot, points, near);
    if (view.held && view.chosen) return drag(view, plot, points);
    std::optional<std::size_t> gone;
    if (ImGui::IsItemHovered() && ImGui::IsMouseClicked(ImGuiMouseButton_Right)) gone = near;
    if (!ImGui::GetIO().WantTextInput && is_key_pressed(key::remove, false)) gone = view.chosen;
    if (!gone || !remove_point(points, *gone)) return false;
    view.chosen.reset();
    return true;
}

void draw(const CurveView& view, const CurvePlot& plot, const CurvePoints& points,
          std::optional<std::size_t> near, bool hovered) {
    const std::optional<std::size_t> marked = near && !view.held ? near : view.chosen;
    draw_curve(plot, points, marked);
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    if (marked && (near || view.held))
        draw_curve_reading(plot, points[*marked].first, points[*marked].second);
    else if (hovered && plot.contains(mouse))
        draw_curve_reading(plot, plot.angle_at(mouse.x), plot.value_at(mouse.y));
    const float size = reach * ImGui::GetFontSize() / 15;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const ImVec2 at = plot.at(points[i].first, points[i].second);
        note_part("Curve point " + std::to_string(i + 1), {at.x - size, at.y - size},
                  {at.x + size, at.y + size});
    }
}

bool plot_area(CurveView& view, CurvePoints& points) {
    const float size = ImGui::GetFontSize();
    const ImVec2 area(ImGui::GetContentRegionAvail().x, size * plot_ems);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::InvisibleButton("plot", area);
    const CurvePlot plot{
        .low = {corner.x + size * 2.3f, corner.y + size * 0.5f},
        .high = {corner.x + area.x - size * 0.5f, corner.y + area.y - size * 1.3f},
        .axes = view.held ? view.held->axes : axes_for(points, view.logarithmic, view.angle_end)};
    note_part("Curve", plot.low, plot.high);
    const bool hovered = ImGui::IsItemHovered();
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const auto near = hovered ? point_near(plot, points, mouse) : std::nullopt;
    const bool changed = handle_mouse(view, plot, points, near);
    const bool same = !changed || view.held;
    draw(view, plot, points, same && hovered ? point_near(plot, points, mouse) : std::nullopt, hovered);
    return changed;
}

bool shape_buttons(CurveView& view, CurvePoints& points) {
    bool changed = false;
    for (const CurveShape& shape : curve_shapes()) {
        if (button(shape.name, shape.explanation)) {
            points = shape.points;
            view.chosen.reset();
            changed = true;
        }
        ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
    }
    ImGui::NewLine();
    return changed;
}

std::string range_text(double end) { return "0\u2013" + std::to_string(int(end)) + "\u00b0"; }

void axes_row(CurveView& view) {
    if (button(
            view.logarithmic ? "Log##Curve scale" : "Lin##Curve scale",
            "Heights: logarithmic over four decades and more, with a strip below them that goes down to 0; "
            "or linear. The curve stays the same."))
        view.logarithmic = !view.logarithmic;
    ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
    ImGui::SetNextItemWidth(ImGui::GetFontSize() * 5.6f);
    const bool open = ImGui::BeginCombo("##angles", range_text(view.angle_end).c_str());
    note_item("Curve angles");
    tooltip_for_item("The angles that the plot shows.");
    if (!open) return;
    for (const double end : angle_ends) {
        if (ImGui::Selectable(range_text(end).c_str(), view.angle_end == end)) view.angle_end = end;
        note_item("Curve angles " + std::to_string(int(end)));
    }
    ImGui::EndCombo();
}

bool number(const SliderSpec& spec, float width, double& value) {
    ImGui::SetNextItemWidth(width);
    return number_field(spec, spec.label, value);
}

// Between a point and the next one, or before the last.
std::pair<double, double> halfway(const CurvePoints& points, std::size_t index) {
    const std::size_t first = std::min(index, points.size() - 2);
    const double angle = (points[first].first + points[first + 1].first) / 2;
    return {angle, curve_value(points, angle)};
}

// The chosen point's numbers; without one, what the mouse does.
bool point_row(CurveView& view, CurvePoints& points) {
    ImGui::AlignTextToFramePadding();
    if (!view.chosen) {
        if (button("Points##First point", "Choose the first point, to type its numbers.")) view.chosen = 0;
        ImGui::SameLine();
        dim_text("A click adds a point, a right click removes it.");
        return false;
    }
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x, side = ImGui::GetFrameHeight();
    const std::size_t index = *view.chosen;
    ImGui::PushID(static_cast<int>(index));
    if (button("\u203a##Next point", "The next point.", true, side))
        view.chosen = (index + 1) % points.size();
    ImGui::SameLine(0, gap);
    const float width = (ImGui::GetContentRegionAvail().x - 2 * side - 3 * gap) / 2;
    auto point = points[index];
    const auto [least, most] = angle_room(points, index);
    bool changed = number({.label = "Point angle",
                           .low = least,
                           .high = most,
                           .least = least,
                           .most = most,
                           .reset = point.first,
                           .format = "%.5g\u00b0",
                           .tooltip = "Angle from the lobe's axis, between those of the neighbours."},
                          width, point.first);
    ImGui::SameLine(0, gap);
    changed |= number({.label = "Point value",
                       .low = 0,
                       .high = 1,
                       .least = 0,
                       .most = limits::weight_max,
                       .reset = point.second,
                       .format = "%.6g",
                       .tooltip = "p there, up to a factor: the layer's weight says how much it is in all."},
                      width, point.second);
    if (changed) set_point(points, index, point);
    ImGui::SameLine(0, gap);
    if (button("+##Add point", "Another point, halfway to the next one.", true, side)) {
        if (const auto added = add_point(points, halfway(points, index))) {
            view.chosen = added;
            changed = true;
        }
    }
    ImGui::SameLine(0, gap);
    if (button("\u00d7##Remove point", "Remove this point.", points.size() > 2, side) &&
        remove_point(points, index)) {
        view.chosen.reset();
        changed = true;
    }
    ImGui::PopID();
    return changed;
}

}  // namespace

bool curve_editor(CurveView& view, CurveLobe& curve) {
    CurvePoints& points = curve.points;
    // An undo, or another layer.
    if (view.chosen && *view.chosen >= points.size()) view.chosen.reset(), view.held.reset();
    ImGui::PushID("curve");
    ImGui::BeginGroup();
    bool changed = shape_buttons(view, points);
    changed |= plot_area(view, points);
    axes_row(view);
    changed |= point_row(view, points);
    ImGui::EndGroup();
    ImGui::PopID();
    const bool elsewhere = !ImGui::IsMouseHoveringRect(ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
    if (elsewhere && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) view.chosen.reset();
    return changed;
}

}  // namespace nacre::ui
