#include "ui/slider_bar.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "ui/focus.h"
#include "ui/item_map.h"
#include "ui/number_item.h"
#include "ui/theme.h"

namespace nacre::ui {
namespace {

// Where the number stands in a bar: at its right where there is room for that, since the bar's end so often
// lies in the middle.
struct NumberPlace {
    char text[64];
    float begin, end;
};

NumberPlace number_place(const SliderSpec& spec, double value, const NumberItem& item, float margin) {
    NumberPlace place{};
    std::snprintf(place.text, sizeof(place.text), spec.format, value);
    const float width = ImGui::CalcTextSize(place.text).x;
    const float centred = item.low.x + (item.high.x - item.low.x - width) / 2;
    const float at_right = item.high.x - ImGui::GetStyle().FramePadding.x - margin - width;
    place.begin = std::max(at_right, std::min(centred, item.low.x + margin));
    place.end = place.begin + width;
    return place;
}

void draw_number(const NumberItem& item, const char* text, float left) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.PushClipRect(item.low, item.high, true);
    list.AddText({left, item.low.y + ImGui::GetStyle().FramePadding.y}, ImGui::GetColorU32(ImGuiCol_Text),
                 text);
    list.PopClipRect();
}

void draw_frame(const NumberItem& item) {
    ImGui::GetWindowDrawList()->AddRectFilled(
        item.low, item.high, ImGui::GetColorU32(item.hovered ? palette::field_hovered : palette::field),
        ImGui::GetStyle().FrameRounding);
}

void draw_bar(const SliderSpec& spec, double value, bool marked, const NumberItem& item) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const ImVec2 low = item.low, high = item.high;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    draw_frame(item);
    const auto x_of = [&](double at) { return slider_mark(spec, at, low.x, high.x); };
    const float x = x_of(value);
    const float origin = spec.low < 0 ? x_of(0) : low.x;
    list.AddRectFilled({std::min(origin, x), low.y}, {std::max(origin, x), high.y},
                       ImGui::GetColorU32(palette::accent_dim), style.FrameRounding);
    const float half = std::max(1.0f, std::round(ImGui::GetFontSize() / 15)) * 1.0f;
    const auto mark = [&](float top, float bottom) {
        if (marked)
            list.AddRectFilled({x - half, top}, {x + half, bottom},
                               ImGui::GetColorU32(item.hovered ? palette::accent_bright : palette::accent),
                               half);
    };
    const NumberPlace number = number_place(spec, value, item, slider_margin());
    draw_number(item, number.text, number.begin);
    // The mark leaves a gap for the number.
    const float inset = scaled(2), tick = style.FramePadding.y;
    if (x + 2 * half < number.begin || x - 2 * half > number.end) {
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
    if (!begin_second_menu("reset")) return false;
    const bool reset = ImGui::Selectable(reset_text(spec).c_str());
    note_item(name + " reset");
    ImGui::EndPopup();
    return reset;
}

}  // namespace

bool slider_field(const SliderSpec& spec, const std::string& name, double& value, bool marked) {
    const double before = value;
    ImGui::PushID(name.c_str());
    const NumberItem item = number_item(spec, NumberHandling::slide, name, value);
    note_item(name);
    if (!item.typing) {
        tooltip_for_item(spec.tooltip);
        if (reset_requested(spec, name)) value = spec.reset;
        draw_bar(spec, value, marked, item);
    }
    ImGui::PopID();
    return value != before;
}

bool number_field(const SliderSpec& spec, const std::string& name, double& value) {
    const double before = value;
    ImGui::PushID(name.c_str());
    const NumberItem item = number_item(spec, NumberHandling::type, name, value);
    note_item(name);
    if (!item.typing) {
        tooltip_for_item(spec.tooltip);
        if (item.hovered) ImGui::SetMouseCursor(ImGuiMouseCursor_TextInput);
        char text[64];
        std::snprintf(text, sizeof(text), spec.format, value);
        draw_frame(item);
        draw_number(item, text, item.low.x + ImGui::GetStyle().FramePadding.x);
    }
    ImGui::PopID();
    return value != before;
}

}  // namespace nacre::ui
