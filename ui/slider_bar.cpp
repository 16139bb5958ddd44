#include "ui/slider_bar.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "ui/item_map.h"
#include "ui/theme.h"

namespace nacre::ui {
namespace {

// Where the value lies between the ends, 0 to 1.
float fraction(const SliderSpec& spec, double value) {
    const double clamped = std::clamp(value, spec.low, spec.high);
    const double share = spec.logarithmic ? std::log(clamped / spec.low) / std::log(spec.high / spec.low)
                                          : (clamped - spec.low) / (spec.high - spec.low);
    return static_cast<float>(share);
}

void bar(const SliderSpec& spec, double& value, bool marked) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const float width = ImGui::CalcItemWidth();
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const ImVec2 high(low.x + width, low.y + ImGui::GetFrameHeight());
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const bool hovered = ImGui::IsMouseHoveringRect(low, high) && ImGui::IsWindowHovered();
    list.AddRectFilled(low, high, ImGui::GetColorU32(hovered ? palette::field_hovered : palette::field),
                       style.FrameRounding);

    // As far from the ends as Dear ImGui keeps the middle of its grab.
    const float margin = 2 + style.GrabMinSize * 0.5f;
    const auto x_of = [&](double at) { return low.x + margin + fraction(spec, at) * (width - 2 * margin); };
    const float x = x_of(value);
    const float origin = spec.low < 0 ? x_of(0) : low.x;
    list.AddRectFilled({std::min(origin, x), low.y}, {std::max(origin, x), high.y},
                       ImGui::GetColorU32(palette::accent_dim), style.FrameRounding);
    const float half = std::max(1.0f, std::round(ImGui::GetFontSize() / 15)) * 1.0f;
    const auto mark = [&](float top, float bottom) {
        if (marked)
            list.AddRectFilled({x - half, top}, {x + half, bottom},
                               ImGui::GetColorU32(hovered ? palette::accent_bright : palette::accent), half);
    };

    for (const ImGuiCol colour : {ImGuiCol_FrameBg, ImGuiCol_FrameBgHovered, ImGuiCol_FrameBgActive,
                                  ImGuiCol_SliderGrab, ImGuiCol_SliderGrabActive})
        ImGui::PushStyleColor(colour, ImVec4(0, 0, 0, 0));
    // Dear ImGui centres the number, where the bar's end so often lies; ours stands at the right
    // where there is room for that.
    const bool typing = ImGui::TempInputIsActive(ImGui::GetID("##value"));
    if (!typing) ImGui::PushStyleColor(ImGuiCol_Text, ImVec4(0, 0, 0, 0));
    const ImGuiSliderFlags flags = spec.logarithmic ? ImGuiSliderFlags_Logarithmic : ImGuiSliderFlags_None;
    ImGui::SliderScalar("##value", ImGuiDataType_Double, &value, &spec.low, &spec.high, spec.format, flags);
    ImGui::PopStyleColor(typing ? 5 : 6);
    if (typing) return;
    char text[64];
    std::snprintf(text, sizeof(text), spec.format, value);
    const float breadth = ImGui::CalcTextSize(text).x, centred = low.x + (width - breadth) / 2;
    const float at_right = high.x - style.FramePadding.x - margin - breadth;
    const float begin = std::max(at_right, std::min(centred, low.x + margin)), end = begin + breadth;
    list.PushClipRect(low, high, true);
    list.AddText({begin, low.y + style.FramePadding.y}, ImGui::GetColorU32(ImGuiCol_Text), text);
    list.PopClipRect();
    // The mark leaves a gap for the number.
    const float inset = scaled(2), tick = style.FramePadding.y;
    if (x + 2 * half < begin || x - 2 * half > end) {
        mark(low.y + inset, high.y - inset);
    } else {
        mark(low.y, low.y + tick);
        mark(high.y - tick, high.y);
    }
}

std::string reset_text(const SliderSpec& spec) {
    char text[64];
    std::snprintf(text, sizeof(text), spec.format, spec.reset);
    return "Reset to " + std::string(text);
}

// Of the last item.
bool reset_requested(const SliderSpec& spec, const std::string& name) {
    if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
        ImGui::ClearActiveID();  // else the held button goes on setting the value
        return true;
    }
    if (!ImGui::BeginPopupContextItem("reset")) return false;
    const bool reset = ImGui::Selectable(reset_text(spec).c_str());
    note_item(name + " reset");
    ImGui::EndPopup();
    return reset;
}

}  // namespace

bool slider_field(const SliderSpec& spec, const std::string& name, double& value, bool marked) {
    const double before = value;
    ImGui::PushID(name.c_str());
    bar(spec, value, marked);
    note_item(name);
    tooltip_for_item(spec.tooltip);
    if (reset_requested(spec, name)) value = spec.reset;
    ImGui::PopID();
    value = std::isnan(value) ? before : std::clamp(value, spec.least, spec.most);
    return value != before;
}

}  // namespace nacre::ui
