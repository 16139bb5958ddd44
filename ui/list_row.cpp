#include "ui/list_row.h"

#include <imgui.h>

#include "ui/item_map.h"
#include "ui/theme.h"

namespace nacre::ui {

bool list_row(const char* name, const ListRow& row) {
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const bool clicked = ImGui::InvisibleButton(
        "row", ImVec2(ImGui::GetContentRegionAvail().x - row.free_at_right, ImGui::GetFrameHeight()));
    note_item(name);
    const ImVec2 high = ImGui::GetItemRectMax();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImGuiStyle& style = ImGui::GetStyle();
    if (row.chosen || ImGui::IsItemHovered())
        list.AddRectFilled(low, high, ImGui::GetColorU32(row.chosen ? palette::accent_dim : palette::field),
                           style.FrameRounding);
    const float right = high.x - style.FramePadding.x - ImGui::CalcTextSize(row.at_right.c_str()).x;
    const float top = low.y + style.FramePadding.y;
    list.AddText({right, top}, ImGui::GetColorU32(row.chosen ? palette::text : palette::text_dim),
                 row.at_right.c_str());
    list.PushClipRect(low, {right - style.ItemInnerSpacing.x, high.y}, true);
    list.AddText({low.x + style.FramePadding.x, top},
                 ImGui::GetColorU32(row.dimmed ? palette::text_dim : palette::text), row.text.c_str());
    list.PopClipRect();
    return clicked;
}

}  // namespace nacre::ui
