#include "ui/plot_view.h"

#include <algorithm>
#include <cmath>

#include "ui/item_map.h"
#include "ui/plot_pen.h"

namespace nacre::ui {
namespace {

constexpr double degrees_per_pixel = 0.4;
constexpr double zoom_per_notch = 1.15, zoom_max = 20;
constexpr double angle_step = 0.1;  // degrees, of a drag

void drag_light(PlotSettings& settings, const PlotLayout& layout, glm::dvec2 pixel) {
    const double angle = std::round(std::fabs(lobe_angle(layout, pixel)) / angle_step) * angle_step;
    settings.incidence = std::min(angle, incidence_max);
}

void turn_shape(ShapeView& view) {
    const ImGuiIO& io = ImGui::GetIO();
    if (ImGui::IsItemActive()) {
        view.yaw = std::remainder(view.yaw + static_cast<double>(io.MouseDelta.x) * degrees_per_pixel, 360.0);
        view.pitch =
            std::clamp(view.pitch + static_cast<double>(io.MouseDelta.y) * degrees_per_pixel, 0.0, 90.0);
    }
    if (!ImGui::IsItemHovered()) return;
    if (io.MouseWheel != 0)
        view.zoom = std::clamp(view.zoom * std::pow(zoom_per_notch, static_cast<double>(io.MouseWheel)), 1.0,
                               zoom_max);
    if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) view = {};
}

}  // namespace

std::optional<PlotReading> plot_view(PlotsState& state, const Plot& plot, ImTextureID slice) {
    const ImVec2 room = ImGui::GetContentRegionAvail(), corner = ImGui::GetCursorScreenPos();
    const ImVec2 size(std::max(room.x, 1.0f), std::max(room.y, 1.0f));
    ImGui::InvisibleButton("Plot", size);
    note_item("Plot");
    const bool hovered = ImGui::IsItemHovered(), active = ImGui::IsItemActive();
    PlotPenOnScreen pen(slice);
    const PlotBox box{{corner.x, corner.y}, {corner.x + size.x, corner.y + size.y}};
    const PlotLayout layout = layout_plot(plot, box, pen);
    const glm::dvec2 pixel(ImGui::GetIO().MousePos.x, ImGui::GetIO().MousePos.y);
    const bool lobe = std::holds_alternative<LobePlot>(plot.contents);
    const bool shape = std::holds_alternative<ShapePlot>(plot.contents);
    if (active && lobe) drag_light(state.settings, layout, pixel);
    if (shape) turn_shape(state.view);
    std::optional<PlotReading> reading;
    if (hovered && !(active && (lobe || shape))) reading = read_plot(plot, layout, state.view, pixel);
    ImGui::PushClipRect(corner, {corner.x + size.x, corner.y + size.y}, true);
    draw_plot(pen, plot, layout, state.view, reading);
    ImGui::PopClipRect();
    return reading;
}

}  // namespace nacre::ui
