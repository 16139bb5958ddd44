#include "ui/presets_panel.h"

#include <algorithm>

#include "ui/focus.h"
#include "ui/item_map.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace nacre::ui {
namespace {

float padding() { return 0.3f * ImGui::GetTextLineHeight(); }

// The largest height of the names below a row of tiles.
float names_height(std::span<const PresetTile> row, float width) {
    float height = 0;
    for (const PresetTile& shown : row)
        height = std::max(height,
                          ImGui::CalcTextSize(shown.name.c_str(), nullptr, false, width - 2 * padding()).y);
    return height;
}

// A picture with its name below. Returns whether it was clicked.
bool tile(const PresetTile& shown, const char* kind, float width, float name_height, bool chosen) {
    const float pad = padding();
    const float picture = width - 2 * pad;
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const bool clicked = ImGui::InvisibleButton("tile", ImVec2(width, picture + name_height + 3 * pad));
    note_item(std::string(kind) + " " + as_label(shown.name));
    tooltip_for_item(("Click: a new design as \u201c" + shown.name +
                      "\u201d; Undo brings back the one before. Right click: its layers for this design.")
                         .c_str());
    const ImVec2 high = ImGui::GetItemRectMax();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImGuiStyle& style = ImGui::GetStyle();
    if (chosen || ImGui::IsItemHovered())
        list.AddRectFilled(low, high, ImGui::GetColorU32(chosen ? palette::accent_dim : palette::field),
                           style.FrameRounding);
    const ImVec2 corner(low.x + pad, low.y + pad), end(corner.x + picture, corner.y + picture);
    if (shown.picture != nullptr)
        list.AddImageRounded(shown.picture, corner, end, ImVec2(0, 0), ImVec2(1, 1), IM_COL32_WHITE,
                             style.FrameRounding);
    else
        list.AddRectFilled(corner, end, ImGui::GetColorU32(palette::canvas), style.FrameRounding);
    const char* name = shown.name.c_str();
    const ImVec2 text = ImGui::CalcTextSize(name, nullptr, false, picture);
    list.PushClipRect(low, high, true);
    list.AddText(ImGui::GetFont(), ImGui::GetFontSize(),
                 {low.x + (width - std::min(text.x, picture)) / 2, end.y + pad},
                 ImGui::GetColorU32(palette::text), name, nullptr, picture);
    list.PopClipRect();
    return clicked;
}

}  // namespace

PresetChoice presets_panel(std::span<const PresetTile> tiles, std::optional<std::size_t> current,
                           const char* kind, float tile_ems) {
    PresetChoice choice;
    ImGui::PushID(kind);
    if (tiles.empty()) dim_text("No presets were found.");
    const float room = ImGui::GetContentRegionAvail().x, gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const std::size_t columns =
        static_cast<std::size_t>(std::max(1.0f, (room + gap) / (tile_ems * ImGui::GetFontSize() + gap)));
    const float width = (room + gap) / static_cast<float>(columns) - gap;
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(gap, gap));
    float name_height = 0;
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        if (i % columns != 0)
            ImGui::SameLine();
        else
            name_height = names_height(tiles.subspan(i, std::min(columns, tiles.size() - i)), width);
        ImGui::PushID(static_cast<int>(i));
        if (tile(tiles[i], kind, width, name_height, current == i)) choice.begun = i;
        if (ImGui::IsItemHovered() || has_focus()) choice.hovered = i;
        if (begin_second_menu("of preset")) {
            if (ImGui::Selectable("Add as layer")) choice.added = i;
            note_item("Add preset as layer");
            ImGui::EndPopup();
        }
        ImGui::PopID();
    }
    ImGui::PopStyleVar();
    ImGui::PopID();
    return choice;
}

}  // namespace nacre::ui
