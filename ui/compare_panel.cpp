#include "ui/compare_panel.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cfloat>
#include <utility>

#include "ui/edit_name.h"
#include "ui/focus.h"
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

// Of the last item.
std::optional<SnapshotAction> snapshot_menu(const std::string& prefix) {
    if (!begin_second_menu("menu")) return std::nullopt;
    std::optional<SnapshotAction> action;
    const auto entry = [&](const char* label, const char* name, const char* text, SnapshotAction what) {
        if (ImGui::MenuItem(label)) action = what;
        note_item(prefix + name);
        tooltip_for_item(text);
    };
    entry("Compare at the left", " left", "The left side of the comparison shows it; so does the key A.",
          SnapshotAction::to_left);
    entry("Compare at the right", " right", "The right side of the comparison shows it.",
          SnapshotAction::to_right);
    ImGui::Separator();
    entry("Delete", " remove", "Forgets this snapshot.", SnapshotAction::remove);
    ImGui::EndPopup();
    return action;
}

// The small picture, which is a button.
std::optional<SnapshotAction> snapshot_picture(const SnapshotRow& row, const std::string& prefix,
                                               float side) {
    const ImVec2 low = ImGui::GetCursorScreenPos(), high(low.x + side, low.y + side);
    const bool clicked = ImGui::InvisibleButton("picture", ImVec2(side, side));
    note_item(prefix + " restore");
    tooltip_for_item(
        "A click makes this the design that is edited; one step of undo brings the other back. The right "
        "button: compare with it, or delete it.");
    const bool hovered = ImGui::IsItemHovered();
    const float rounding = ImGui::GetStyle().FrameRounding;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (row.picture != nullptr)
        list.AddImageRounded(row.picture, low, high, ImVec2(0, 0), ImVec2(1, 1), IM_COL32_WHITE, rounding);
    else
        list.AddRectFilled(low, high, ImGui::GetColorU32(palette::canvas), rounding);
    if (hovered) list.AddRect(low, high, ImGui::GetColorU32(palette::accent), rounding, 0, scaled(2));
    if (!clicked) return snapshot_menu(prefix);
    name_edit(prefix);
    return SnapshotAction::restore;
}

// Picture, letter and name, and where the comparison has it.
std::optional<SnapshotAction> snapshot_row(const SnapshotRow& row, const CompareState& state) {
    const std::string prefix = "Snapshot " + row.letter;
    ImGui::PushID(row.letter.c_str());
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const auto action =
        snapshot_picture(row, prefix, 2 * ImGui::GetFrameHeight() + ImGui::GetStyle().ItemSpacing.y);
    ImGui::SameLine(0, 2 * gap);
    ImGui::BeginGroup();
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(row.letter.c_str());
    ImGui::SameLine(0, 2 * gap);
    ImGui::SetNextItemWidth(-FLT_MIN);
    ImGui::InputTextWithHint("##name", "Untitled", row.name);
    note_item(prefix + " name");
    tooltip_for_item("The name that the preview shows for this snapshot.");
    dim_text(state.left == row.id    ? "the left side, and what A shows"
             : state.right == row.id ? "the right side"
                                     : "");
    ImGui::EndGroup();
    ImGui::PopID();
    return action;
}

std::optional<SnapshotRequest> snapshot_list(std::span<const SnapshotRow> snapshots,
                                             const CompareState& state) {
    std::optional<SnapshotRequest> request;
    heading("Snapshots");
    for (std::size_t i = 0; i < snapshots.size(); ++i)
        if (const auto action = snapshot_row(snapshots[i], state)) request = {*action, i};
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
    const std::optional<SnapshotRequest> request = snapshot_list(snapshots, state);
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
