#include "ui/history_panel.h"

#include <imgui.h>

#include "core/base/utf8.h"
#include "ui/list_row.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace nacre::ui {
namespace {

constexpr float row_gap = 2;  // pixels

// Whether the list has another present step than in the frame before.
bool has_moved(std::size_t present, std::size_t count) {
    ImGuiStorage& storage = *ImGui::GetStateStorage();
    const ImGuiID step = ImGui::GetID("present"), steps = ImGui::GetID("count");
    const int now = static_cast<int>(present), all = static_cast<int>(count);
    const bool moved = storage.GetInt(step, -1) != now || storage.GetInt(steps, -1) != all;
    storage.SetInt(step, now);
    storage.SetInt(steps, all);
    return moved;
}

}  // namespace

std::optional<std::size_t> history_panel(std::span<const HistoryRow> rows, std::size_t present) {
    std::optional<std::size_t> clicked;
    ImGui::Separator();
    ImGui::Spacing();
    heading("History");
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ImGui::GetStyle().ItemSpacing.x, row_gap));
    ImGui::BeginChild("steps", ImVec2(0, 0));
    const bool moved = has_moved(present, rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        const std::string name = "Step " + std::to_string(i);
        if (list_row(name.c_str(), {.text = as_utf8(rows[i].what),
                                    .at_right = {},
                                    .chosen = i == present,
                                    .dimmed = rows[i].later}))
            clicked = i;
        if (moved && i == present) ImGui::SetScrollHereY();
        tooltip_for_item(i == present    ? "The design as it is now."
                         : rows[i].later ? "A click does again what was taken back, up to this. It is gone "
                                           "once something new is done."
                                         : "A click takes back what was done since this.");
        ImGui::PopID();
    }
    ImGui::EndChild();
    ImGui::PopStyleVar();
    return clicked;
}

}  // namespace nacre::ui
