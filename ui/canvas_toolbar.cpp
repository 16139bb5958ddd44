#include "ui/canvas_toolbar.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "ui/canvas_tools.h"
#include "ui/item_map.h"
#include "ui/keys.h"
#include "ui/theme.h"
#include "ui/tool_row.h"
#include "ui/toolbar_fields.h"
#include "ui/widgets.h"

namespace nacre::ui {
namespace {

constexpr double key_factor = 1.15;  // of the radius, for each press of [ or ]

void tool_button(CanvasState& state, const ToolEntry& entry) {
    const float side = ImGui::GetFrameHeight();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    if (ImGui::InvisibleButton(entry.face->name, ImVec2(side, side))) state.tool = entry.tool;
    note_item(entry.face->name);
    const bool chosen = state.tool == entry.tool, hovered = ImGui::IsItemHovered();
    if (chosen || hovered)
        ImGui::GetWindowDrawList()->AddRectFilled(
            corner, {corner.x + side, corner.y + side},
            ImGui::GetColorU32(chosen ? palette::accent_dim : palette::field),
            ImGui::GetStyle().FrameRounding);
    draw_tool_icon(*entry.face, corner, side,
                   ImGui::GetColorU32(chosen ? palette::accent_bright : palette::text));
    if (hovered) tooltip_for_item(tool_tooltip(*entry.face).c_str());
}

float scale_width() { return button_width(density_scales[2].label) + ImGui::GetFrameHeight(); }

// Where they do not fit on one line, whole groups go to the next.
void tool_buttons(CanvasState& state) {
    const auto tools = canvas_tools();
    const float side = ImGui::GetFrameHeight(), gap = scaled(2);
    for (auto entry = tools.begin(); entry != tools.end(); ++entry) {
        const bool begins = entry->face->begins_group;
        const auto next = std::find_if(entry + 1, tools.end(),
                                       [](const ToolEntry& later) { return later.face->begins_group; });
        const float rest = static_cast<float>(next - entry) * (side + gap) - gap;
        if (entry != tools.begin()) stay_on_line(begins ? rest : side, begins ? scaled(8) : gap);
        tool_button(state, *entry);
    }
}

void take_keys(CanvasState& state) {
    const ImGuiIO& io = ImGui::GetIO();
    if (io.WantTextInput || io.KeyCtrl || io.KeyAlt || ImGui::IsAnyMouseDown() ||
        ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel))
        return;
    for (const ToolEntry& entry : canvas_tools())
        if (is_key_pressed(entry.face->key, false)) state.tool = entry.tool;
}

}  // namespace

void view_choices(CanvasState& state) {
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    int scale = static_cast<int>(state.scale);
    choice("Scale", scale, labels_of(density_scales), scale_width(), density_scales[scale].about);
    state.scale = static_cast<ScaleKind>(scale);
    HemisphereCamera& camera = state.camera;
    ImGui::SameLine(0, gap);
    if (button(
            camera.highlight ? "Highlight##Seen as" : "Facets##Seen as",
            "Highlight: as it stands on the lit object. Facets: by where their normals point, which is the "
            "other way around, since facets that are tilted down shine above the highlight's middle.")) {
        camera.highlight = !camera.highlight;
        camera.centre = -camera.centre;
    }
    ImGui::SameLine(0, gap);
    if (button(camera.dome ? "Dome##Dome" : "Disk##Dome",
               "All facet normals as an equal-area disk seen from above, or as a dome that the right button "
               "turns.")) {
        camera.dome = !camera.dome;
        camera = camera.whole();
    }
}

void resize_brush(CanvasState& state, int steps) {
    state.brush.radius =
        std::clamp(state.brush.radius * std::pow(key_factor, steps), brush_radius_min, brush_radius_max);
}

void canvas_toolbar(CanvasState& state, const std::optional<dvec3>& mean, Distribution& distribution,
                    std::size_t& chosen) {
    take_keys(state);
    tool_buttons(state);
    stay_on_line(button_width("+"), ImGui::GetStyle().ItemSpacing.x);
    if (button("+##New painted layer", "A new layer to paint on, with nothing on it yet.",
               distribution.layers.size() < limits::layers_max)) {
        add_painted_layer(distribution, chosen);
        if (state.tool == CanvasTool::handles) state.tool = CanvasTool::paint;
    }
    // As high for every tool, so that what is below stays where it is.
    const float room = ImGui::GetContentRegionAvail().x;
    int most = 0;
    for (const ToolEntry& entry : canvas_tools())
        most = std::max(most, tool_row(entry.tool, state, mean, distribution).lines(room));
    const ToolbarRow row = tool_row(state.tool, state, mean, distribution);
    row.draw();
    if (const int empty = most - row.lines(room); empty > 0)
        ImGui::Dummy({0, static_cast<float>(empty) * ImGui::GetFrameHeightWithSpacing() -
                             ImGui::GetStyle().ItemSpacing.y});
}

}  // namespace nacre::ui
