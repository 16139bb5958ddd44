#include "ui/tool_row.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "ui/balance_buttons.h"
#include "ui/brush_settings.h"
#include "ui/canvas_select.h"
#include "ui/canvas_tools.h"
#include "ui/canvas_transform.h"
#include "ui/stamp_row.h"
#include "ui/toolbar_fields.h"
#include "ui/widgets.h"

namespace nacre::ui {
namespace {

constexpr const char* symmetries[] = {"No symmetry", "Mirror x", "Mirror y",
                                      "Mirror both", "Turns",    "Full ring"};

float turns_width() { return std::floor(ImGui::GetFontSize() * 2.6f); }
float symmetry_width() { return std::floor(button_width("No symmetry") + ImGui::GetFrameHeight()); }

// Of each of the three numbers, so that the whole row fits on one line wherever it can.
float number_width(float others) {
    const float size = ImGui::GetFontSize();
    const float room = ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x - others;
    return std::floor(std::clamp(room / 3, size * 4.4f, size * 6.2f));
}

// What this tool needs.
void add_need(ToolbarRow& row, CanvasState& state, ToolNeed need, float width) {
    switch (need) {
        case ToolNeed::tolerance:
            return row.add(width, [&state, width] {
                percent(
                    "Tolerance", "Tolerance %.0f %%",
                    "How much values may differ from the one that is pointed at and still be filled with it.",
                    width, usual_tolerance, state.tolerance);
            });
        case ToolNeed::form:
            return row.add(width, [&state, width] {
                int form = static_cast<int>(state.form);
                choice("Gradient form", form, labels_of(gradient_forms), width,
                       "Linear: across the drag. Radial: around the press.");
                state.form = static_cast<GradientForm>(form);
            });
        case ToolNeed::picture:
            return add_stamp(row, state, width);
        case ToolNeed::rays:
            return row.add(width, [&state, width] {
                whole_number("Rays", "%.0f rays", {3, 24, usual_rays}, width, "How many rays the star has.",
                             state.rays);
            });
        case ToolNeed::hardness:
            return row.add(width, [&state, width] {
                percent("Hardness", "Hard %.0f %%",
                        "How much of the brush covers in full, from its middle; from there to the edge it "
                        "fades.",
                        width, Brush{}.hardness, state.brush.hardness);
            });
    }
}

// What a tool needs that is as wide as the brush.
void add_dab_numbers(ToolbarRow& row, CanvasState& state, ToolNeed need, float width) {
    row.add(width, [&state, width] {
        bar({.label = "Brush radius",
             .low = brush_radius_min,
             .high = brush_radius_max,
             .least = brush_radius_min,
             .most = brush_radius_max,
             .reset = Brush{}.radius,
             .format = "Size %.1f\u00b0",
             .logarithmic = true,
             .tooltip = "The brush's radius on the hemisphere, degrees from its middle to its edge; the keys "
                        "[ and ], or comma and point, change it."},
            width, state.brush.radius);
    });
    add_need(row, state, need, width);
    row.add(width, [&state, width] {
        percent("Flow", "Flow %.0f %%",
                "How much one touch of the brush does: low flow builds up stroke by stroke.", width,
                Brush{}.flow, state.brush.flow);
    });
}

// What one needs that covers an area at once.
void add_area_numbers(ToolbarRow& row, CanvasState& state, ToolNeed need, float width) {
    add_need(row, state, need, width);
    row.add(width, [&state, width] {
        percent("Paint value", "value %.0f %%", "How much is painted, of full paint: the brush's value.",
                width, Brush{}.value, state.brush.value);
    });
    row.add(width, [&state, width] {
        percent("Paint opacity", "opacity %.0f %%",
                "How much of its full effect it has: the brush's opacity.", width, Brush{}.opacity,
                state.brush.opacity);
    });
    row.add(width, [&state, width] { combine_choice(state.brush, "Combine area", width); });
}

void add_symmetry(ToolbarRow& row, CanvasState& state) {
    row.add(symmetry_width(), [&state] {
        int kind = static_cast<int>(state.symmetry.kind);
        choice("Symmetry", kind, {std::begin(symmetries), std::end(symmetries)}, symmetry_width(),
               "Copies of each stroke about the layer's axis: mirrored, turned, or all around, as for a "
               "surface that looks the same from all sides.");
        state.symmetry.kind = static_cast<SymmetryKind>(kind);
    });
    if (state.symmetry.kind != SymmetryKind::turns) return;
    row.add(turns_width(), [&state] {
        whole_number("Turns", "\u00d7 %.0f", {turns_min, turns_max, BrushSymmetry{}.turns}, turns_width(),
                     "How many copies, evenly rotated about the axis.", state.symmetry.turns);
    });
}

ToolbarRow brush_row(CanvasState& state, const PaintToolInfo& tool, const std::optional<dvec3>& mean,
                     Distribution& distribution) {
    ToolbarRow row;
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const bool turned = state.symmetry.kind == SymmetryKind::turns;
    const float settings = button_width(brush_settings_text);
    const bool wide = is_as_wide_as_brush(tool);
    // What stands beside the numbers of an area goes to the next line.
    const float width = number_width(
        wide ? symmetry_width() + settings + 4 * gap + (turned ? turns_width() + gap : 0) : 2 * gap);
    if (wide)
        add_dab_numbers(row, state, tool.needs, width);
    else
        add_area_numbers(row, state, tool.needs, width);
    add_symmetry(row, state);
    row.add(settings, [&state] { brush_settings(state); });
    // Beside the highlight the mean normal is not seen.
    if (!state.camera.highlight)
        row.add(button_width(balance_text), [&] { balance_button(state, mean, distribution); });
    return row;
}

// What stands in place of the brush's numbers while there is no brush.
ToolbarRow handles_row(CanvasTool tool, CanvasState& state, const std::optional<dvec3>& mean,
                       Distribution& distribution) {
    ToolbarRow row;
    row.add(button_width(balance_text), [&] { balance_button(state, mean, distribution); });
    row.add(button_width(straighten_text), [&] { straighten_button(mean, distribution); });
    row.add_hint(tool == CanvasTool::grab ? "Drag a highlight, here or on the sphere."
                                          : "Drag a lobe's middle, ends or outline.");
    return row;
}

}  // namespace

ToolbarRow tool_row(CanvasTool tool, CanvasState& state, const std::optional<dvec3>& mean,
                    Distribution& distribution) {
    if (const auto paints = paints_with(tool)) return brush_row(state, info(*paints), mean, distribution);
    if (selects_with(tool)) return selection_row(state);
    if (tool == CanvasTool::transform) return transform_row(state, distribution);
    return handles_row(tool, state, mean, distribution);
}

}  // namespace nacre::ui
