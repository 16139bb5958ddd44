// Colours are linear in the design and in the three fields, as tables of measured reflectance print them; the
// swatch beside them shows and picks the colour as a display does.
#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>

#include "core/image/srgb.h"
#include "ui/edit_name.h"
#include "ui/item_map.h"
#include "ui/keys.h"
#include "ui/slider_bar.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace nacre::ui {
namespace {

// The inverse of srgb_encoded().
double decoded(double value) {
    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

void linear_fields(const char* label, glm::dvec3& linear, glm::dvec3 reset, const char* tooltip_text) {
    static constexpr const char* channels[] = {" red", " green", " blue"};
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const float width =
        std::floor((ImGui::GetContentRegionAvail().x - ImGui::GetFrameHeight() - 3 * gap) / 3);
    ImGui::BeginGroup();
    for (int i = 0; i < 3; ++i) {
        if (i > 0) ImGui::SameLine(0, gap);
        ImGui::SetNextItemWidth(width);
        slider_field({.label = label,
                      .low = 0,
                      .high = 1,
                      .least = 0,
                      .most = 1,
                      .reset = reset[i],
                      .format = "%.3f",
                      .logarithmic = false,
                      .tooltip = tooltip_text},
                     std::string(item_name(label)) + channels[i], linear[i], false);
    }
    ImGui::EndGroup();
    note_part(label, ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
}

struct DisplayColour {
    float values[3];
};

DisplayColour displayed(const glm::dvec3& linear) {
    DisplayColour shown{};
    for (int i = 0; i < 3; ++i) shown.values[i] = static_cast<float>(srgb_encoded(linear[i]));
    return shown;
}

// A channel that was not touched keeps all its digits.
void take(const DisplayColour& before, const DisplayColour& now, glm::dvec3& linear) {
    for (int i = 0; i < 3; ++i)
        if (now.values[i] != before.values[i])
            linear[i] = std::clamp(decoded(static_cast<double>(now.values[i])), 0.0, 1.0);
}

// "#rrggbb", with or without the sign.
std::optional<DisplayColour> hexadecimal(std::string_view text) {
    if (text.starts_with('#')) text.remove_prefix(1);
    unsigned code = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), code, 16);
    if (text.size() != 6 || error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    DisplayColour colour{};
    for (int i = 0; i < 3; ++i) colour.values[i] = static_cast<float>(code >> (16 - 8 * i) & 255) / 255;
    return colour;
}

// Until six digits stand there the colour stays as it is, and the digits are red.
// Returns whether what has been typed is one.
bool hexadecimal_field(const std::string& name, glm::dvec3& linear) {
    const DisplayColour before = displayed(linear);
    int bytes[3];
    for (int i = 0; i < 3; ++i) bytes[i] = static_cast<int>(std::lround(before.values[i] * 255));
    std::string text = fmt::format("#{:02x}{:02x}{:02x}", bytes[0], bytes[1], bytes[2]);
    const std::string first = text;
    ImGui::SetNextItemWidth(-FLT_MIN);
    ImGuiStorage& storage = *ImGui::GetStateStorage();
    const ImGuiID key = ImGui::GetID("wrong digits");
    const bool wrong = storage.GetBool(key);
    if (wrong) ImGui::PushStyleColor(ImGuiCol_Text, palette::red);
    // A colour can be typed as soon as the picker opens.
    if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
    const bool edited = ImGui::InputText("##hexadecimal", &text, ImGuiInputTextFlags_AutoSelectAll);
    if (wrong) ImGui::PopStyleColor();
    note_item(name + " hexadecimal");
    tooltip_for_item("As displayed: six hexadecimal digits, as on the web.");
    const auto typed = hexadecimal(text);
    storage.SetBool(key, ImGui::IsItemActive() && (edited ? !typed : wrong));
    if (!edited || !typed || text == first) return typed && !wrong;
    DisplayColour now = *typed;
    for (int i = 0; i < 3; ++i)
        if (std::lround(now.values[i] * 255) == bytes[i]) now.values[i] = before.values[i];
    take(before, now, linear);
    return true;
}

void swatch(const std::string& name, glm::dvec3& linear) {
    constexpr ImGuiColorEditFlags flags = ImGuiColorEditFlags_Float | ImGuiColorEditFlags_NoInputs;
    const DisplayColour before = displayed(linear);
    DisplayColour now = before;
    const bool pressed = ImGui::ColorButton("##swatch", {now.values[0], now.values[1], now.values[2], 1},
                                            ImGuiColorEditFlags_NoAlpha | ImGuiColorEditFlags_NoTooltip);
    const bool by_key = pressed && !ImGui::IsMouseReleased(ImGuiMouseButton_Left);
    if (ImGui::IsItemClicked() || by_key) ImGui::OpenPopup("picker");
    note_item(name + " swatch");
    tooltip_for_item("A click picks the colour as it is displayed, a drag carries it to another swatch.");
    if (ImGui::BeginDragDropTarget()) {
        if (const ImGuiPayload* carried = ImGui::AcceptDragDropPayload(IMGUI_PAYLOAD_TYPE_COLOR_3F))
            std::memcpy(now.values, carried->Data, sizeof now.values);
        ImGui::EndDragDropTarget();
    }
    if (ImGui::BeginPopup("picker")) {
        ImGui::SetNextItemWidth(ImGui::GetFrameHeight() * 12);
        ImGui::ColorPicker3("##picker", now.values,
                            flags | ImGuiColorEditFlags_PickerHueWheel | ImGuiColorEditFlags_NoSidePreview |
                                ImGuiColorEditFlags_NoLabel);
        note_item(name + " picker");
        if (hexadecimal_field(name, linear) && is_key_pressed(key::enter, false)) ImGui::CloseCurrentPopup();
        ImGui::EndPopup();
    }
    take(before, now, linear);
}

}  // namespace

bool colour(const char* label, glm::dvec3& linear, glm::dvec3 reset, const char* tooltip_text) {
    const glm::dvec3 before = linear;
    if (row_label(label, tooltip_text)) linear = reset;
    ImGui::PushID(label);
    linear_fields(label, linear, reset, tooltip_text);
    ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
    swatch(std::string(item_name(label)), linear);
    ImGui::PopID();
    if (linear != before) name_edit(visible_text(label));
    return linear != before;
}

void colour_patch(glm::dvec3 linear, float side) {
    const DisplayColour now = displayed(linear);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::GetWindowDrawList()->AddRectFilled(
        at, {at.x + side, at.y + side},
        ImGui::ColorConvertFloat4ToU32({now.values[0], now.values[1], now.values[2], 1}), 3);
    ImGui::Dummy({side, side});
    ImGui::SameLine();
}

}  // namespace nacre::ui
