#include "ui/canvas_toolbar.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "ui/balance_buttons.h"
#include "ui/brush_settings.h"
#include "ui/canvas_select.h"
#include "ui/canvas_tools.h"
#include "ui/canvas_transform.h"
#include "ui/item_map.h"
#include "ui/keys.h"
#include "ui/slider_bar.h"
#include "ui/stamp_row.h"
#include "ui/theme.h"
#include "ui/toolbar_fields.h"
#include "ui/widgets.h"

namespace nacre::ui {
namespace {

constexpr const char* symmetries[] = {"No symmetry", "Mirror x", "Mirror y",
                                      "Mirror both", "Turns",    "Full ring"};
constexpr double key_factor = 1.15;  // of the radius, for each press of [ or ]
constexpr float hint_ems = 9;        // the least width to read a hint in

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

// The middle of the row: what this tool needs.
void tool_number(CanvasState& state, ToolNeed need, float width) {
    if (need == ToolNeed::tolerance) {
        percent("Tolerance", "Tolerance %.0f %%",
                "How much values may differ from the one that is pointed at and still be filled with it.",
                width, usual_tolerance, state.tolerance);
    } else if (need == ToolNeed::form) {
        int form = static_cast<int>(state.form);
        choice("Gradient form", form, labels_of(gradient_forms), width,
               "Linear: across the drag. Radial: around the press.");
        state.form = static_cast<GradientForm>(form);
    } else if (need == ToolNeed::picture) {
        stamp_row(state, width, ImGui::GetStyle().ItemInnerSpacing.x);
    } else if (need == ToolNeed::rays) {
        whole_number("Rays", "%.0f rays", {3, 24, usual_rays}, width, "How many rays the star has.",
                     state.rays);
    } else {
        percent("Hardness", "Hard %.0f %%",
                "How much of the brush covers in full, from its middle; from there to the edge it fades.",
                width, Brush{}.hardness, state.brush.hardness);
    }
}

// Of each of the three numbers, so that the whole row fits on one line wherever it can.
float number_width(float others) {
    const float size = ImGui::GetFontSize();
    const float room = ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x - others;
    return std::clamp(room / 3, size * 4.4f, size * 6.2f);
}

// What a tool needs that is as wide as the brush.
void dab_numbers(CanvasState& state, ToolNeed need, float width, float gap) {
    bar({.label = "Brush radius",
         .low = brush_radius_min,
         .high = brush_radius_max,
         .least = brush_radius_min,
         .most = brush_radius_max,
         .reset = Brush{}.radius,
         .format = "Size %.1f\u00b0",
         .logarithmic = true,
         .tooltip = "The brush's radius on the hemisphere, degrees from its middle to its edge; the keys [ "
                    "and ], or "
                    "comma and point, change it."},
        width, state.brush.radius);
    stay_on_line(width, gap);
    tool_number(state, need, width);
    stay_on_line(width, gap);
    percent("Flow", "Flow %.0f %%",
            "How much one touch of the brush does: low flow builds up stroke by stroke.", width, Brush{}.flow,
            state.brush.flow);
}

// What one needs that covers an area at once.
void area_numbers(CanvasState& state, ToolNeed need, float width, float gap) {
    tool_number(state, need, width);
    stay_on_line(width, gap);
    percent("Paint value", "value %.0f %%", "How much is painted, of full paint: the brush's value.", width,
            Brush{}.value, state.brush.value);
    stay_on_line(width, gap);
    percent("Paint opacity", "opacity %.0f %%", "How much of its full effect it has: the brush's opacity.",
            width, Brush{}.opacity, state.brush.opacity);
    stay_on_line(width, gap);
    combine_choice(state.brush, "Combine area", width);
}

void brush_row(CanvasState& state, PaintTool tool, const std::optional<dvec3>& mean,
               Distribution& distribution) {
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x, size = ImGui::GetFontSize();
    const bool turned = state.symmetry.kind == SymmetryKind::turns;
    const float menu = button_width("No symmetry") + ImGui::GetFrameHeight(), turns = size * 2.6f;
    const float settings = button_width(brush_settings_text);
    const bool wide = is_as_wide_as_brush(info(tool));
    // What stands beside the numbers of an area goes to the next line.
    const float width = number_width(wide ? menu + settings + 4 * gap + (turned ? turns + gap : 0) : 2 * gap);
    if (wide)
        dab_numbers(state, info(tool).needs, width, gap);
    else
        area_numbers(state, info(tool).needs, width, gap);
    stay_on_line(menu, gap);
    int kind = static_cast<int>(state.symmetry.kind);
    choice("Symmetry", kind, {std::begin(symmetries), std::end(symmetries)}, menu,
           "Copies of each stroke about the layer's axis: mirrored, turned, or all around, as for a surface "
           "that looks the same from all sides.");
    state.symmetry.kind = static_cast<SymmetryKind>(kind);
    if (turned) {
        stay_on_line(turns, gap);
        whole_number("Turns", "\u00d7 %.0f", {turns_min, turns_max, BrushSymmetry{}.turns}, turns,
                     "How many copies, evenly rotated about the axis.", state.symmetry.turns);
    }
    stay_on_line(button_width(brush_settings_text), gap);
    brush_settings(state);
    if (state.camera.highlight) return;  // the mean normal is seen beside the facets
    stay_on_line(button_width(balance_text), gap);
    balance_button(state, mean, distribution);
}

// What stands in place of the brush's numbers while there is no brush.
void handles_row(CanvasState& state, const std::optional<dvec3>& mean, Distribution& distribution) {
    balance_button(state, mean, distribution);
    ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
    straighten_button(mean, distribution);
    ImGui::SameLine();
    if (ImGui::GetContentRegionAvail().x < hint_ems * ImGui::GetFontSize()) return ImGui::NewLine();
    ImGui::AlignTextToFramePadding();
    ImGui::PushStyleColor(ImGuiCol_Text, palette::text_dim);
    ImGui::TextWrapped("%s", state.tool == CanvasTool::grab ? "Drag a highlight, here or on the sphere."
                                                            : "Drag a lobe's middle, ends or outline.");
    ImGui::PopStyleColor();
}

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
    if (const auto tool = paints_with(state.tool))
        brush_row(state, *tool, mean, distribution);
    else if (selects_with(state.tool))
        selection_row(state);
    else if (state.tool == CanvasTool::transform)
        transform_row(state, distribution);
    else
        handles_row(state, mean, distribution);
}

}  // namespace nacre::ui
