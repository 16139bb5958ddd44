#include "ui/brush_settings.h"

#include <algorithm>
#include <string>

#include "ui/focus.h"
#include "ui/item_map.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace nacre::ui {
namespace {

constexpr const char* popup_name = "Brush settings";
constexpr float popup_ems = 24;
constexpr std::size_t own_brushes_max = 64;

void follows(const char* label, const char* about, Follows& what) {
    int index = static_cast<int>(what);
    combo(label, index, follows_kinds, about);
    what = static_cast<Follows>(index);
}

void percent(const char* label, double low, double high, double reset, const char* about, double& part) {
    double value = part * 100;
    if (slider({.label = label,
                .low = low,
                .high = high,
                .least = low,
                .most = high,
                .reset = reset * 100,
                .format = "%.0f %%",
                .logarithmic = false,
                .tooltip = about},
               value))
        part = value / 100;
}

// A row of the list. Returns whether it was chosen.
bool entry(const NamedBrush& named, const Brush& present) {
    const std::string label = as_label(named.name);
    const bool chosen =
        ImGui::Selectable(label.c_str(), named.brush == present, ImGuiSelectableFlags_DontClosePopups);
    note_item("Brush " + label);
    return chosen;
}

void list_of_brushes(CanvasState& state) {
    static const std::vector<NamedBrush> built_in = built_in_brushes();
    for (const NamedBrush& named : built_in)
        if (entry(named, state.brush)) state.brush = named.brush;
    std::optional<std::size_t> removed;
    for (std::size_t i = 0; i < state.own_brushes.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        if (entry(state.own_brushes[i], state.brush)) state.brush = state.own_brushes[i].brush;
        if (begin_second_menu("of brush")) {
            if (ImGui::Selectable("Remove")) removed = i;
            note_item("Remove brush");
            ImGui::EndPopup();
        }
        ImGui::PopID();
    }
    if (removed) state.own_brushes.erase(state.own_brushes.begin() + static_cast<std::ptrdiff_t>(*removed));
}

void keep_as(CanvasState& state) {
    text_field("Name##Brush name", state.brush_name, "of a brush of your own",
               "A name for the current brush.");
    const auto same = [&](const NamedBrush& named) { return named.name == state.brush_name; };
    const auto found = std::find_if(state.own_brushes.begin(), state.own_brushes.end(), same);
    const bool room = found != state.own_brushes.end() || state.own_brushes.size() < own_brushes_max;
    if (!button("Keep brush",
                "Puts the brush into the list under this name, for all designs. A right click on "
                "it there removes it.",
                !state.brush_name.empty() && room))
        return;
    if (found != state.own_brushes.end())
        found->brush = state.brush;
    else
        state.own_brushes.push_back({state.brush_name, state.brush});
    state.brush_name.clear();
}

}  // namespace

void brush_settings(CanvasState& state) {
    if (button((std::string(brush_settings_text) + "##Brush settings").c_str(),
               "Brushes with names; opacity, spacing, value, how paint combines, a steady hand."))
        ImGui::OpenPopup(popup_name);
    ImGui::SetNextWindowSize({ImGui::GetFontSize() * popup_ems, 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(scaled(12), scaled(10)));
    const bool open = ImGui::BeginPopup(popup_name);
    ImGui::PopStyleVar();
    if (!open) return;
    list_of_brushes(state);
    ImGui::Spacing();
    const Brush usual;
    Brush& brush = state.brush;
    percent("Opacity", 0, 100, usual.opacity,
            "The most that one whole stroke does, however often it goes over a place.", brush.opacity);
    percent("Value", 0, 100, usual.value,
            "How much is painted, of full paint. Ctrl or Alt with a click picks the value that is there.",
            brush.value);
    percent("Spacing", spacing_min * 100, spacing_max * 100, usual.spacing,
            "From one touch of the brush to the next, of its radius. From 100 % on they come apart.",
            brush.spacing);
    int blend = static_cast<int>(brush.blend);
    combo("Combine", blend, blends, "How paint combines with what the layer has.");
    brush.blend = static_cast<Blend>(blend);
    follows("Size follows", "What of the hand makes the brush wider and narrower.", brush.radius_follows);
    follows("Flow follows", "What of the hand makes the paint stronger and weaker.", brush.flow_follows);
    slider({.label = "Steady hand",
            .low = 0,
            .high = 100,
            .least = 0,
            .most = 400,
            .reset = 0,
            .format = "%.0f px",
            .logarithmic = false,
            .tooltip = "The brush trails the pointer on a string of this length, which smooths its path."},
           state.steadiness);
    ImGui::Spacing();
    keep_as(state);
    ImGui::EndPopup();
}

}  // namespace nacre::ui
