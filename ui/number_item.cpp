#include "ui/number_item.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "ui/escape.h"
#include "ui/focus.h"
#include "ui/item_map.h"
#include "ui/theme.h"
#include "ui/typed_number.h"

namespace nacre::ui {
namespace {

constexpr const char* item_label = "##value";
constexpr double complaint_seconds = 8;
constexpr float complaint_ems = 17;  // width of its text
constexpr float drag_pixels = 3;     // a shorter one is a click, which moves nothing

// Only one field at a time has the keyboard, and only one the mouse.
struct Typing {
    ImGuiID id = 0;
    int frame = 0;  // in which it was last drawn: later it is another field's number, or another context's
    double before = 0;
    std::string first;  // text
    char text[64] = "";
};
Typing typing;

struct Complaint {
    ImGuiID id = 0;
    std::string text;
    double since = 0;
};
Complaint complaint;

// The last on a slider: it begins a drag, or a second one may follow.
struct Press {
    bool awaits_second = false;
    double before = 0, time = 0;
    float away = 0;  // pixels from the pointer to the slider's mark
    bool drags = false;
};
Press press;

NumberRange range_of(const SliderSpec& spec) {
    return {.least = spec.least, .most = spec.most, .whole = spec.whole, .infinite = spec.infinite};
}

void begin_typing(ImGuiID id, double value) {
    typing = {.id = id, .before = value, .first = plain_number(value)};
    std::snprintf(typing.text, sizeof(typing.text), "%s", typing.first.c_str());
    if (complaint.id == id) complaint = {};
}

// What the typed text makes of the number.
void apply(const SliderSpec& spec, double& value, bool ended) {
    value = typing.before;
    complaint = {};
    if (typing.text == typing.first) return;
    const TypedNumber typed = typed_number(typing.text, spec.format, range_of(spec));
    if (typed.problem.empty())
        value = typed.value;
    else if (ended || typing.text[0] != 0)
        complaint = {.id = typing.id, .text = typed.problem, .since = ImGui::GetTime()};
}

// Returns whether the field is being typed into.
bool type_into(const SliderSpec& spec, ImGuiID id, const ImRect& box, bool begins, double& value) {
    const int frame = ImGui::GetFrameCount();
    if (begins)
        begin_typing(id, value);
    else if (typing.id != id || frame < typing.frame || frame > typing.frame + 1)
        return false;
    if (begins || ImGui::TempInputIsActive(id)) {
        typing.frame = frame;
        const bool wrong = complaint.id == id;
        if (wrong) ImGui::PushStyleColor(ImGuiCol_Text, palette::red);
        ImGui::TempInputText(box, id, item_label, typing.text, sizeof(typing.text),
                             ImGuiInputTextFlags_AutoSelectAll);
        if (wrong) ImGui::PopStyleColor();
    }
    const bool ended = ImGui::GetActiveID() != id;
    apply(spec, value, ended);
    if (ended) typing = {};
    return !ended;
}

// By hundredths of the slider, within what may be typed.
void step(const SliderSpec& spec, double steps, double& value) {
    if (steps == 0 || !std::isfinite(value)) return;
    const double before = value, part = steps / 100;
    value = spec.logarithmic ? value * std::pow(spec.high / spec.low, part)
                             : value + part * (spec.high - spec.low);
    if (spec.whole)
        value = before + std::copysign(std::max(1.0, std::round(std::fabs(value - before))), steps);
    value = std::clamp(value, std::min(spec.least, before), std::max(spec.most, before));
}

bool drag_begins() {
    const float reach = scaled(drag_pixels);
    return ImGui::GetIO().MouseDragMaxDistanceSqr[ImGuiMouseButton_Left] > reach * reach;
}

// The mark goes with the pointer as far as that goes, wherever in the slider it was pressed.
void slide(const SliderSpec& spec, ImGuiID id, const ImRect& box, double& value) {
    if (ImGui::GetActiveID() != id) return;
    if (take_escape_of_drag()) {
        value = press.before;
        return;
    }
    if (!ImGui::IsMouseDown(ImGuiMouseButton_Left)) return ImGui::ClearActiveID();
    press.drags |= drag_begins();
    if (!press.drags) return;
    const ImGuiSliderFlags flags = spec.logarithmic ? ImGuiSliderFlags_Logarithmic : ImGuiSliderFlags_None;
    ImRect grab;
    float& pointer = ImGui::GetIO().MousePos.x;
    const float there = std::exchange(pointer, pointer + press.away);
    const bool changed = ImGui::SliderBehavior(box, id, ImGuiDataType_Double, &value, &spec.low, &spec.high,
                                               spec.format, flags, &grab);
    pointer = there;
    if (!changed) return;
    if (spec.whole) value = std::round(value);
    ImGui::MarkItemEdited(id);
}

// Below the box, until something else is clicked or some seconds are over.
void draw_complaint(const ImRect& box, const std::string& name) {
    const bool left = typing.id != complaint.id && ImGui::GetTime() > complaint.since;
    if (left && (ImGui::IsMouseClicked(ImGuiMouseButton_Left) ||
                 ImGui::GetTime() > complaint.since + complaint_seconds)) {
        complaint = {};
        return;
    }
    const float size = ImGui::GetFontSize(), width = complaint_ems * size;
    const char* text = complaint.text.c_str();
    const ImVec2 padding = ImGui::GetStyle().FramePadding;
    const ImVec2 extent = ImGui::CalcTextSize(text, nullptr, false, width);
    const float right = ImGui::GetMainViewport()->Size.x - extent.x - 2 * padding.x;
    const ImVec2 low(std::max(std::min(box.Min.x, right), 0.0f), box.Max.y + scaled(2));
    const ImVec2 high(low.x + extent.x + 2 * padding.x, low.y + extent.y + 2 * padding.y);
    ImDrawList& list = *ImGui::GetForegroundDrawList();
    const float rounding = ImGui::GetStyle().FrameRounding;
    list.AddRectFilled(low, high, ImGui::GetColorU32(ImGuiCol_PopupBg), rounding);
    list.AddRect(low, high, ImGui::GetColorU32(palette::red), rounding);
    list.AddText(ImGui::GetFont(), size, {low.x + padding.x, low.y + padding.y},
                 ImGui::GetColorU32(palette::red), text, nullptr, width);
    note_part(name + " problem", low, high);
}

// Whether the pointer may act on the item last added, and whether Tab came to it: Dear ImGui since 1.90, and
// before.
#if IMGUI_VERSION_NUM >= 19000
bool is_hovered(const ImRect& box, ImGuiID id) {
    return ImGui::ItemHoverable(box, id, ImGui::GetCurrentContext()->LastItemData.InFlags);
}
bool is_tabbed(ImGuiID) { return false; }  // counts as activated
#else
bool is_hovered(const ImRect& box, ImGuiID id) { return ImGui::ItemHoverable(box, id); }
bool is_tabbed(ImGuiID) {
    const ImGuiItemStatusFlags flags = ImGui::GetCurrentContext()->LastItemData.StatusFlags;
    return (flags & ImGuiItemStatusFlags_FocusedByTabbing) != 0;
}
#endif

}  // namespace

float slider_mark(const SliderSpec& spec, double value, float low, float high) {
    const double at = std::clamp(value, spec.low, spec.high);
    const double share = spec.logarithmic ? std::log(at / spec.low) / std::log(spec.high / spec.low)
                                          : (at - spec.low) / (spec.high - spec.low);
    // As far from the ends as Dear ImGui keeps the middle of its grab.
    const float margin = slider_margin();
    return low + margin + static_cast<float>(share) * (high - low - 2 * margin);
}

float slider_margin() { return 2 + ImGui::GetStyle().GrabMinSize * 0.5f; }

NumberItem number_item(const SliderSpec& spec, NumberHandling handling, const std::string& name,
                       double& value) {
    ImGuiWindow& window = *ImGui::GetCurrentWindow();
    const ImGuiID id = window.GetID(item_label);
    const ImVec2 low = window.DC.CursorPos;
    const ImRect box(low, {low.x + ImGui::CalcItemWidth(), low.y + ImGui::GetFrameHeight()});
    NumberItem item{.low = box.Min, .high = box.Max};
    ImGui::ItemSize(box, ImGui::GetStyle().FramePadding.y);
    if (!ImGui::ItemAdd(box, id, &box, ImGuiItemFlags_Inputable)) return item;
    item.hovered = is_hovered(box, id);
    bool begins = false;
    if (!ImGui::TempInputIsActive(id)) {
        const bool tabbed = is_tabbed(id) || ImGui::GetCurrentContext()->NavActivateId == id;
        const bool clicked = item.hovered && ImGui::IsMouseClicked(ImGuiMouseButton_Left);
        if (tabbed || clicked) {
            ImGui::SetActiveID(id, &window);
            ImGui::SetFocusID(id, &window);
            ImGui::FocusWindow(&window);
            begins = tabbed || handling == NumberHandling::type || ImGui::GetIO().KeyCtrl;
            if (!begins)
                press = {.awaits_second = true,
                         .before = value,
                         .time = ImGui::GetTime(),
                         .away = slider_mark(spec, value, box.Min.x, box.Max.x) - ImGui::GetIO().MousePos.x};
        }
    }
    const double before = value;
    if (KeyboardFocus* const focus = keyboard_focus()) step(spec, focus->take_steps(), value);
    if (value != before) ImGui::MarkItemEdited(id);
    item.typing = type_into(spec, id, box, begins, value);
    if (!item.typing && handling == NumberHandling::slide) slide(spec, id, box, value);
    if (complaint.id == id) draw_complaint(box, name);
    return item;
}

bool slider_awaits_second_click() {
    if (!press.awaits_second) return false;
    const ImGuiIO& io = ImGui::GetIO();
    const float reach = io.MouseDoubleClickMaxDist;
    const double since = ImGui::GetTime() - press.time;
    const bool elsewhere = since > 0 && ImGui::IsMouseClicked(ImGuiMouseButton_Left) &&
                           !ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
    const bool dragged = io.MouseDragMaxDistanceSqr[ImGuiMouseButton_Left] > reach * reach;
    if (since < 0 || since > static_cast<double>(io.MouseDoubleClickTime) || elsewhere || dragged)
        press.awaits_second = false;
    return press.awaits_second;
}

}  // namespace nacre::ui
