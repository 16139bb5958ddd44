#include "ui/import_dialog.h"

#include <algorithm>

#include "core/base/utf8.h"
#include "ui/dialogs.h"
#include "ui/escape.h"
#include "ui/item_map.h"
#include "ui/keys.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace nacre::ui {
namespace {

constexpr float dialog_ems = 54;
constexpr float left_part = 0.4f;  // of the width, for what is said of the chosen card
constexpr float field_rows = 7;    // room for the settings of any card, so that nothing jumps

struct Pressed {
    bool once = false, twice = false;
};

// A picture with its name below.
Pressed card(const ImportCard& shown, float width, bool chosen, bool likely) {
    const float line = ImGui::GetTextLineHeight(), pad = line * 0.4f, side = width - 2 * pad;
    const ImVec2 low = ImGui::GetCursorScreenPos();
    Pressed pressed;
    pressed.once = ImGui::InvisibleButton(shown.name, ImVec2(width, side + line + 3 * pad));
    const bool hovered = ImGui::IsItemHovered();
    pressed.twice = hovered && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
    note_item(std::string("As ") + shown.name);
    note_part(shown.name, ImGui::GetItemRectMin(), ImGui::GetItemRectMax());  // as scripts may call it
    tooltip_for_item(shown.refusal.empty() ? shown.about : shown.refusal.c_str());
    const ImVec2 high = ImGui::GetItemRectMax();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float rounding = ImGui::GetStyle().FrameRounding;
    if (chosen || hovered)
        list.AddRectFilled(low, high, ImGui::GetColorU32(chosen ? palette::accent_dim : palette::field),
                           rounding);
    if (chosen)
        list.AddRect(low, high, ImGui::GetColorU32(palette::accent_bright), rounding, 0, scaled(1.5f));
    const ImVec2 corner(low.x + pad, low.y + pad), end(corner.x + side, corner.y + side);
    list.AddRectFilled(corner, end, ImGui::GetColorU32(palette::canvas), rounding);
    const bool usable = shown.refusal.empty();
    if (usable && shown.picture != nullptr)
        list.AddImageRounded(shown.picture, corner, end, {0, 0}, {1, 1}, IM_COL32_WHITE, rounding);
    const char* inside = usable ? (shown.picture != nullptr ? "" : "\u2026") : "\u2013";
    const ImVec2 extent = ImGui::CalcTextSize(inside);
    list.AddText({corner.x + (side - extent.x) / 2, corner.y + (side - extent.y) / 2},
                 ImGui::GetColorU32(palette::text_dim), inside);
    if (likely)
        list.AddText({corner.x + pad, corner.y + pad / 2}, ImGui::GetColorU32(palette::accent_bright),
                     "likely");
    const float text = ImGui::CalcTextSize(shown.name).x;
    list.AddText({low.x + (width - text) / 2, end.y + pad},
                 ImGui::GetColorU32(usable ? palette::text : palette::text_dim), shown.name);
    return pressed;
}

// Returns whether one was clicked twice.
bool row_of_cards(const ImportContents& contents, std::size_t& chosen) {
    const auto count = static_cast<float>(contents.cards.size());
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const float width = (ImGui::GetContentRegionAvail().x - (count - 1) * gap) / count;
    bool twice = false;
    for (std::size_t i = 0; i < contents.cards.size(); ++i) {
        if (i > 0) ImGui::SameLine(0, gap);
        const Pressed pressed = card(contents.cards[i], width, i == chosen, i == contents.likely);
        if (pressed.once || pressed.twice) chosen = i;
        twice |= pressed.twice;
    }
    return twice;
}

void choose_by_key(std::size_t count, std::size_t& chosen) {
    if (is_key_pressed(key::right, true) && chosen + 1 < count) ++chosen;
    if (is_key_pressed(key::left, true) && chosen > 0) --chosen;
}

void words(const ImportContents& contents, std::size_t chosen) {
    const ImportCard& shown = contents.cards[chosen];
    ImGui::TextWrapped("%s", shown.about);
    if (!shown.refusal.empty()) warning_text(as_utf8(shown.refusal));
    if (chosen == contents.likely && !contents.why.empty()) dim_text("Likely, since " + contents.why + ".");
    if (!contents.remark.empty()) dim_text(as_utf8(contents.remark));
}

ImportAnswer buttons(bool usable) {
    const float width = ImGui::GetFontSize() * 7;
    ImGui::SetCursorPosX(ImGui::GetContentRegionMax().x - 2 * width - ImGui::GetStyle().ItemSpacing.x);
    ImportAnswer answer = ImportAnswer::none;
    ImGui::PushStyleColor(ImGuiCol_Button, palette::accent_dim);
    if (button("Import", "Use the picture as the chosen card shows it. Enter does too.", usable, width))
        answer = ImportAnswer::accepted;
    ImGui::PopStyleColor();
    ImGui::SameLine();
    if (button("Cancel", "Leave everything as it is. Escape does too.", true, width))
        answer = ImportAnswer::cancelled;
    return answer;
}

}  // namespace

ImportAnswer import_dialog(const ImportContents& contents, std::size_t& chosen,
                           const std::function<void()>& fields) {
    if (!begin_dialog("Import picture", dialog_ems)) return ImportAnswer::none;
    // A key that is down already when the dialog comes up was meant for another.
    const bool appears = ImGui::IsWindowAppearing(), typing = ImGui::GetIO().WantTextInput;
    if (!typing && !appears) choose_by_key(contents.cards.size(), chosen);
    ImGui::TextWrapped("What is \u201c%s\u201d to be?", as_utf8(contents.name).c_str());
    ImGui::Spacing();
    const bool twice = row_of_cards(contents, chosen);
    ImGui::Spacing();
    const float height = field_rows * ImGui::GetFrameHeightWithSpacing();
    if (ImGui::BeginTable("below the cards", 2, ImGuiTableFlags_None, ImVec2(0, height))) {
        ImGui::TableSetupColumn("words", ImGuiTableColumnFlags_WidthStretch, left_part);
        ImGui::TableSetupColumn("settings", ImGuiTableColumnFlags_WidthStretch, 1 - left_part);
        ImGui::TableNextColumn();
        words(contents, chosen);
        ImGui::TableNextColumn();
        fields();
        ImGui::EndTable();
    }
    ImGui::Spacing();
    const bool usable = contents.cards[chosen].refusal.empty();
    ImportAnswer answer = buttons(usable);
    const bool enter = !typing && !appears && is_key_pressed(key::enter, false);
    if (usable && (twice || enter)) answer = ImportAnswer::accepted;
    if (!appears && take_escape()) answer = ImportAnswer::cancelled;
    end_dialog(answer != ImportAnswer::none);
    return answer;
}

}  // namespace nacre::ui
