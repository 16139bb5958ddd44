#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "ui/edit_name.h"
#include "ui/item_map.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace nacre::ui {
namespace {

constexpr float lines_min = 4;

// The text as it reads. Returns whether it was clicked.
bool wrapped_text(const std::string& text) {
    const ImVec2 padding = ImGui::GetStyle().FramePadding;
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    const char* shown = text.empty() ? "Click to write down where this comes from." : text.c_str();
    const float wrap = width - 2 * padding.x;
    const float text_height = ImGui::CalcTextSize(shown, nullptr, false, wrap).y;
    const float height = std::max(text_height, lines_min * ImGui::GetTextLineHeight()) + 2 * padding.y;
    const bool clicked = ImGui::InvisibleButton("##Note text", ImVec2(width, height));
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(low, ImGui::GetItemRectMax(),
                       ImGui::GetColorU32(ImGui::IsItemHovered() ? palette::field_hovered : palette::field),
                       ImGui::GetStyle().FrameRounding);
    list.AddText(ImGui::GetFont(), ImGui::GetFontSize(), {low.x + padding.x, low.y + padding.y},
                 ImGui::GetColorU32(text.empty() ? palette::text_dim : palette::text), shown, nullptr, wrap);
    return clicked;
}

}  // namespace

// Dear ImGui's editor of several lines does not wrap them, so it appears only to edit.
bool note_field(std::string& text) {
    ImGuiStorage& storage = *ImGui::GetStateStorage();
    const ImGuiID key = ImGui::GetID("editing note");
    enum State { reading, beginning, editing };
    const int state = storage.GetInt(key, reading);
    bool changed = false;
    if (state == reading) {
        if (wrapped_text(text)) storage.SetInt(key, beginning);
    } else {
        if (state == beginning) ImGui::SetKeyboardFocusHere();
        const ImVec2 size(-FLT_MIN, (lines_min + 2) * ImGui::GetTextLineHeight());
        changed = ImGui::InputTextMultiline("##Note editor", &text, size);
        if (ImGui::IsItemActive())
            storage.SetInt(key, editing);
        else if (state == editing)
            storage.SetInt(key, reading);
    }
    note_item("Note text");
    tooltip_for_item(
        "Where this design comes from and what it is for; it is kept in the file. A click edits it.");
    if (changed) name_edit("Note");
    return changed;
}

}  // namespace nacre::ui
