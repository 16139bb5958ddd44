#include "ui/recovery_dialog.h"

#include <imgui.h>

#include <algorithm>

#include "ui/dialogs.h"
#include "ui/escape.h"
#include "ui/item_map.h"
#include "ui/keys.h"
#include "ui/list_row.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace nacre::ui {
namespace {

constexpr std::size_t rows_shown = 6;

void row_list(const std::vector<RecoveryRow>& rows, std::size_t& chosen) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const float row = 2 * ImGui::GetFrameHeight() + style.ItemSpacing.y;
    const auto shown = static_cast<float>(std::min(rows.size(), rows_shown));
    ImGui::PushStyleColor(ImGuiCol_ChildBg, palette::canvas);
    ImGui::BeginChild("rows", ImVec2(0, shown * row + style.ItemSpacing.y));
    for (std::size_t i = 0; i < rows.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        if (list_row(("Lost work " + std::to_string(i + 1)).c_str(),
                     {.text = rows[i].name, .at_right = rows[i].when, .chosen = i == chosen}))
            chosen = i;
        ImGui::Indent(style.FramePadding.x);
        dim_text(rows[i].where);
        ImGui::Unindent(style.FramePadding.x);
        ImGui::PopID();
    }
    ImGui::EndChild();
    ImGui::PopStyleColor();
}

std::optional<RecoveryAnswer> buttons() {
    struct Choice {
        const char* label;
        RecoveryAnswer answer;
        const char* tooltip;
    };
    static constexpr Choice choices[] = {
        {"Restore", RecoveryAnswer::restore, "Go on with this work. It is marked as unsaved."},
        {"Discard", RecoveryAnswer::discard, "Remove what was kept of this work, for good."},
        {"Later", RecoveryAnswer::later, "Keep all of it. The next start offers it again."}};
    const float width = ImGui::GetFontSize() * 7, gap = ImGui::GetStyle().ItemSpacing.x;
    ImGui::SetCursorPosX(ImGui::GetContentRegionMax().x - 3 * width - 2 * gap);
    std::optional<RecoveryAnswer> answer;
    for (const Choice& choice : choices) {
        const bool first = choice.answer == RecoveryAnswer::restore;
        if (!first) ImGui::SameLine();
        if (first) ImGui::PushStyleColor(ImGuiCol_Button, palette::accent_dim);
        if (button(choice.label, choice.tooltip, true, width)) answer = choice.answer;
        if (first) ImGui::PopStyleColor();
    }
    if (is_key_pressed(key::enter, false)) answer = RecoveryAnswer::restore;
    if (take_escape()) answer = RecoveryAnswer::later;
    return answer;
}

}  // namespace

std::optional<RecoveryAnswer> recovery_dialog(const std::vector<RecoveryRow>& rows, std::size_t& chosen,
                                              const std::string& problem) {
    if (!begin_dialog("Unsaved work was found", 34)) return std::nullopt;
    chosen = std::min(chosen, rows.size() - 1);
    ImGui::TextWrapped("Nacre ended before this was saved. This is what it wrote last of each work.");
    ImGui::Spacing();
    row_list(rows, chosen);
    ImGui::PushStyleColor(ImGuiCol_Text, palette::red);
    ImGui::TextWrapped("%s", problem.c_str());
    ImGui::PopStyleColor();
    const std::optional<RecoveryAnswer> answer = buttons();
    end_dialog(answer.has_value());
    return answer;
}

}  // namespace nacre::ui
