#include "ui/widgets.h"

#include <imgui.h>
#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>

#include "core/base/utf8.h"
#include "ui/edit_name.h"
#include "ui/item_map.h"
#include "ui/slider_bar.h"
#include "ui/theme.h"

namespace nacre::ui {
namespace {

constexpr float label_ems = 8.4f;       // width of the label column in text sizes
constexpr float tooltip_ems = 25;       // width of a tooltip's text
constexpr float tooltip_delay = 0.45f;  // seconds of rest before a field explains itself

// Broken at blanks alone: Dear ImGui would break a number at its decimal point.
std::string broken_at_blanks(const std::string& text, float width) {
    std::string broken;
    std::size_t line = 0;  // where the last one begins
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find(' ', at + 1), text.size());
        const std::string word = text.substr(at, end - at);
        const bool fits = ImGui::CalcTextSize((broken.substr(line) + word).c_str()).x <= width;
        if (!fits && broken.size() > line) {
            broken += '\n';
            line = broken.size();
        }
        broken += word.substr(broken.size() == line && word.front() == ' ' ? 1 : 0);
        at = end;
    }
    return broken;
}

std::string hidden(const char* label) { return "##" + std::string(item_name(label)); }

// What changed a row names the edit as the row is called.
bool named(const char* label, bool changed) {
    if (changed) name_edit(visible_text(label));
    return changed;
}

}  // namespace

void tooltip(const char* text) {
    note_tooltip(text);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(scaled(10), scaled(8)));
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(ImGui::GetFontSize() * tooltip_ems);
    ImGui::TextUnformatted(text);
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
    ImGui::PopStyleVar();
}

void tooltip_for_item(const char* text) {
    if (text == nullptr || !ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
    // Dear ImGui counts the rest only over what can be clicked.
    const bool rested = ImGui::GetItemID() == 0 || ImGui::GetCurrentContext()->HoveredIdTimer > tooltip_delay;
    if (rested && !ImGui::IsAnyMouseDown()) tooltip(text);
}

bool row_label(const char* label, const char* tooltip_text) {
    const std::string text(visible_text(label));
    const float left = ImGui::GetCursorPosX();
    ImGui::AlignTextToFramePadding();
    ImGui::PushStyleColor(ImGuiCol_Text, palette::text_dim);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopStyleColor();
    const bool hovered = ImGui::IsItemHovered();
    tooltip_for_item(tooltip_text);
    ImGui::SameLine();
    ImGui::SetCursorPosX(left + label_ems * ImGui::GetFontSize());
    ImGui::SetNextItemWidth(-FLT_MIN);
    return hovered && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
}

bool slider(const SliderSpec& spec, double& value) {
    const double before = value;
    if (row_label(spec.label, spec.tooltip)) value = spec.reset;
    slider_field(spec, std::string(item_name(spec.label)), value);
    return named(spec.label, value != before);
}

bool slider(SliderSpec spec, glm::dvec3& rgb, glm::dvec3 reset) {
    static constexpr const char* channels[] = {"red", "green", "blue"};
    const glm::dvec3 before = rgb;
    if (row_label(spec.label, spec.tooltip)) rgb = reset;
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const float width = std::floor((ImGui::GetContentRegionAvail().x - 2 * gap) / 3);
    ImGui::BeginGroup();
    for (int i = 0; i < 3; ++i) {
        if (i > 0) ImGui::SameLine(0, gap);
        ImGui::SetNextItemWidth(width);
        spec.reset = reset[i];
        slider_field(spec, std::string(item_name(spec.label)) + " " + channels[i], rgb[i]);
    }
    ImGui::EndGroup();
    note_part(spec.label, ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
    return named(spec.label, rgb != before);
}

bool slider_or_infinity(const SliderSpec& spec, double& value) {
    const double before = value;
    if (row_label(spec.label, spec.tooltip)) value = spec.reset;
    const float box =
        ImGui::GetFrameHeight() + ImGui::CalcTextSize("\u221e").x + 2 * ImGui::GetStyle().ItemInnerSpacing.x;
    bool infinite = std::isinf(value);
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - box);
    if (infinite) {
        char text[] = "infinite";
        ImGui::BeginDisabled();
        ImGui::InputText(hidden(spec.label).c_str(), text, sizeof(text), ImGuiInputTextFlags_ReadOnly);
        ImGui::EndDisabled();
        note_item(spec.label);
    } else {
        SliderSpec unbounded = spec;
        unbounded.infinite = true;
        slider_field(unbounded, std::string(item_name(spec.label)), value);
    }
    ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
    ImGui::PushID(spec.label);
    if (ImGui::Checkbox("\u221e", &infinite)) value = infinite ? HUGE_VAL : spec.reset;
    ImGui::PopID();
    note_item(std::string(item_name(spec.label)) + " infinite");
    tooltip_for_item("Infinite: the lobe becomes a cylinder along this axis, as threads or grooves make it.");
    return named(spec.label, value != before);
}

bool combo(const char* label, int& index, std::span<const char* const> names, const char* tooltip_text,
           std::span<const char* const> explanations, glm::dvec3 (*swatch)(std::size_t)) {
    row_label(label, tooltip_text);
    const int before = index;
    if (swatch != nullptr) {
        colour_patch(swatch(static_cast<std::size_t>(index)), ImGui::GetFrameHeight());
        ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
    }
    // A long list is shown whole, as far as the window has room.
    const ImGuiComboFlags height = names.size() > 8 ? ImGuiComboFlags_HeightLargest : 0;
    if (ImGui::BeginCombo(hidden(label).c_str(), names[static_cast<std::size_t>(index)], height)) {
        for (std::size_t i = 0; i < names.size(); ++i) {
            const bool chosen = index == static_cast<int>(i);
            if (swatch != nullptr) colour_patch(swatch(i), ImGui::GetTextLineHeight());
            if (ImGui::Selectable(names[i], chosen)) index = static_cast<int>(i);
            if (chosen) ImGui::SetItemDefaultFocus();
            note_item(std::string(item_name(label)) + " " + names[i]);
            if (i < explanations.size()) tooltip_for_item(explanations[i]);
        }
        ImGui::EndCombo();
    }
    note_item(label);
    tooltip_for_item(tooltip_text);
    return index != before;
}

bool combo(const char* label, int& index, std::span<const Choice> list, const char* tooltip_text) {
    std::vector<const char*> names, explanations;
    for (const Choice& entry : list) names.push_back(entry.label), explanations.push_back(entry.about);
    return combo(label, index, names, tooltip_text, explanations);
}

bool checkbox(const char* label, bool& value, const char* tooltip_text) {
    row_label(label, tooltip_text);
    const bool changed = ImGui::Checkbox(hidden(label).c_str(), &value);
    note_item(label);
    tooltip_for_item(tooltip_text);
    return named(label, changed);
}

bool text_field(const char* label, std::string& text, const char* hint, const char* tooltip_text) {
    row_label(label, tooltip_text);
    const bool changed = ImGui::InputTextWithHint(hidden(label).c_str(), hint, &text);
    note_item(label);
    tooltip_for_item(tooltip_text);
    return changed;
}

void stay_on_line(float width, float gap) {
    const float right = ImGui::GetItemRectMax().x + gap + width;
    const float end = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
    if (right <= end) ImGui::SameLine(0, gap);
}

float button_width(const char* label) {
    return ImGui::CalcTextSize(label, nullptr, true).x + 2 * ImGui::GetStyle().FramePadding.x;
}

bool button(const char* label, const char* tooltip_text, bool enabled, float width) {
    ImGui::BeginDisabled(!enabled);
    const bool pressed = ImGui::Button(label, ImVec2(width, 0));
    ImGui::EndDisabled();
    note_item(label);
    tooltip_for_item(tooltip_text);
    return pressed;
}

void hint(const char* text) {
    const ImVec2 corner = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    const ImVec2 extent = ImGui::CalcTextSize(text);
    const float pad = scaled(10), bottom = corner.y + size.y - 5.2f * ImGui::GetFontSize();
    const ImVec2 low(corner.x + (size.x - extent.x) / 2 - pad, bottom - extent.y - pad);
    const ImVec2 high(low.x + extent.x + 2 * pad, bottom);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(low, high, ImGui::GetColorU32(palette::accent_dim), scaled(8));
    list.AddText({low.x + pad, low.y + pad / 2}, ImGui::GetColorU32(palette::text), text);
    note_part(text, low, high);
}

void heading(const char* text) {
    ImGui::PushFont(heading_font());
    ImGui::TextUnformatted(text);
    ImGui::PopFont();
    ImGui::Dummy(ImVec2(0, ImGui::GetStyle().ItemSpacing.y * 0.15f));
}

bool section(const char* label) {
    ImGuiStorage& storage = *ImGui::GetStateStorage();
    const ImGuiID key = ImGui::GetID(label);
    bool open = storage.GetBool(key, true);
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float height = ImGui::GetFrameHeight();
    ImGui::PushID(label);
    if (ImGui::InvisibleButton("fold", ImVec2(ImGui::GetContentRegionAvail().x, height))) {
        open = !open;
        storage.SetBool(key, open);
    }
    ImGui::PopID();
    note_item(label);
    const ImVec2 high = ImGui::GetItemRectMax();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec4 back(1, 1, 1, ImGui::IsItemHovered() ? 0.07f : 0.04f);
    list.AddRectFilled(low, high, ImGui::GetColorU32(back), ImGui::GetStyle().FrameRounding);
    const ImVec2 padding = ImGui::GetStyle().FramePadding;
    const float size = ImGui::GetFontSize();
    list.AddText(heading_font(), size, {low.x + padding.x, low.y + padding.y},
                 ImGui::GetColorU32(palette::text), label);
    const char* sign = open ? "\u2212" : "+";
    list.AddText({high.x - padding.x - ImGui::CalcTextSize(sign).x, low.y + padding.y},
                 ImGui::GetColorU32(palette::text_dim), sign);
    ImGui::Spacing();
    return open;
}

void text_row(const char* label, const std::string& text) {
    row_label(label, nullptr);
    ImGui::AlignTextToFramePadding();
    ImGui::TextWrapped("%s", text.c_str());
}

namespace {

void wrapped(const std::string& text, const Colour& colour) {
    ImGui::PushStyleColor(ImGuiCol_Text, colour);
    ImGui::TextWrapped("%s", text.c_str());
    ImGui::PopStyleColor();
}

}  // namespace

void dim_text(const std::string& text) { wrapped(text, palette::text_dim); }

void warning_text(const std::string& text) { wrapped(text, palette::amber); }

void notes_row(std::span<const std::string> notes) {
    for (const std::string& note : notes) {
        dim_text(broken_at_blanks(as_utf8(note), ImGui::GetContentRegionAvail().x));
        note_item(note);
    }
}

}  // namespace nacre::ui
