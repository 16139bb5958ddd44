#include "ui/compare_panel.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cfloat>
#include <utility>

#include "ui/item_map.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace nacre::ui {
namespace {

struct ViewChoice {
    CompareView view;
    const char* label;
    const char* about;
};

constexpr ViewChoice views[] = {
    {CompareView::off, "Off", "The preview shows the design alone."},
    {CompareView::divider, "Divider",
     "One picture left of a line, the other right of it. Drag the line across the preview."},
    {CompareView::difference, "Difference", "What differs between the two, with its number."},
};

void view_row(CompareView& view) {
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const float width = (ImGui::GetContentRegionAvail().x - 2 * gap) / 3;
    for (const ViewChoice& choice : views) {
        if (choice.view != CompareView::off) ImGui::SameLine(0, gap);
        const bool chosen = choice.view == view;
        if (chosen) ImGui::PushStyleColor(ImGuiCol_Button, palette::accent_dim);
        if (ImGui::Button(choice.label, ImVec2(width, 0))) view = choice.view;
        if (chosen) ImGui::PopStyleColor();
        note_item(std::string("View ") + choice.label);
        tooltip_for_item(choice.about);
    }
}

// A line of the list: letter, name, restore, remove.
std::optional<SnapshotAction> snapshot_row(const SnapshotRow& row) {
    std::optional<SnapshotAction> action;
    const std::string prefix = "Snapshot " + row.letter;
    ImGui::PushID(row.letter.c_str());
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(row.letter.c_str());
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x, padding = 2 * ImGui::GetStyle().FramePadding.x;
    const float buttons = ImGui::CalcTextSize("Restore").x + ImGui::CalcTextSize("\u00d7").x + 2 * padding;
    ImGui::SameLine(ImGui::GetFontSize() * 1.5f);
    ImGui::SetNextItemWidth(std::max(ImGui::GetContentRegionAvail().x - buttons - 2 * gap, 1.0f));
    ImGui::InputTextWithHint("##name", "Untitled", row.name);
    note_item(prefix + " name");
    tooltip_for_item("The name that the preview shows for this snapshot.");
    ImGui::SameLine(0, gap);
    if (ImGui::Button("Restore")) action = SnapshotAction::restore;
    note_item(prefix + " restore");
    tooltip_for_item("Makes this the design that is edited. One step of undo brings the other back.");
    ImGui::SameLine(0, gap);
    if (ImGui::Button("\u00d7")) action = SnapshotAction::remove;
    note_item(prefix + " remove");
    tooltip_for_item("Forgets this snapshot.");
    ImGui::PopID();
    return action;
}

std::optional<SnapshotRequest> snapshot_list(std::span<const SnapshotRow> snapshots) {
    std::optional<SnapshotRequest> request;
    heading("Snapshots");
    for (std::size_t i = 0; i < snapshots.size(); ++i)
        if (const auto action = snapshot_row(snapshots[i])) request = {*action, i};
    if (button(
            "Take snapshot",
            "Keeps the design as it is now, to be seen beside what becomes of it. Snapshots last until the "
            "program ends; save a design to keep it for good."))
        request = {SnapshotAction::take, snapshots.size()};
    return request;
}

void side_row(const char* label, int& side, std::span<const SideChoice> choices) {
    const auto chosen = std::find_if(choices.begin(), choices.end(),
                                     [&](const SideChoice& choice) { return choice.id == side; });
    const SideChoice none;
    const SideChoice& shown = chosen == choices.end() ? none : *chosen;
    row_label(label, nullptr);
    ImGui::SetNextItemWidth(-FLT_MIN);
    const std::string hidden = std::string("##") + label;
    const bool open =
        ImGui::BeginCombo(hidden.c_str(), as_label(shown.label).c_str(), ImGuiComboFlags_HeightLarge);
    note_item(label);
    tooltip_for_item(shown.about.c_str());
    if (!open) return;
    for (const SideChoice& choice : choices) {
        ImGui::BeginDisabled(!choice.possible);
        const std::string text = as_label(choice.label);
        ImGui::PushID(choice.id);
        if (ImGui::Selectable(text.c_str(), choice.id == side)) side = choice.id;
        ImGui::PopID();
        ImGui::EndDisabled();
        note_item(text);
        tooltip_for_item(choice.about.c_str());
    }
    ImGui::EndCombo();
}

void difference_rows(CompareState& state) {
    slider({.label = "Amplify",
            .low = 1,
            .high = 64,
            .least = 0.01,
            .most = 1e4,
            .reset = CompareState{}.amplification,
            .format = "\u00d7 %.3g",
            .logarithmic = true,
            .tooltip = "How much the difference is brightened before it is shown."},
           state.amplification);
    checkbox("Signed", state.is_signed,
             "Orange where the right side is brighter, blue where the left one is, black where they are "
             "equal. Off: the difference of each colour, |right \u2212 left|.");
}

}  // namespace

std::optional<SnapshotRequest> compare_panel(CompareState& state, std::span<const SnapshotRow> snapshots,
                                             std::span<const SideChoice> choices,
                                             const std::string& numbers) {
    const std::optional<SnapshotRequest> request = snapshot_list(snapshots);
    ImGui::Spacing();
    heading("Side by side");
    view_row(state.view);
    side_row("Left", state.left, choices);
    side_row("Right", state.right, choices);
    if (button("Swap sides", "Left becomes right, and right left.")) std::swap(state.left, state.right);
    if (state.view == CompareView::difference) difference_rows(state);
    if (!numbers.empty()) {
        ImGui::Spacing();
        dim_text(numbers);
    }
    return request;
}

}  // namespace nacre::ui
