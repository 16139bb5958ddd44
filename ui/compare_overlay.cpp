#include "ui/compare_overlay.h"

#include <algorithm>

#include "core/base/utf8.h"
#include "ui/item_map.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace nacre::ui {
namespace {

constexpr float reach = 0.5f;  // of the divider to either side, in letters' heights
constexpr int bar_steps = 48;

float text_width(const std::string& text) { return ImGui::CalcTextSize(text.c_str()).x; }

// The text, or as much of it as fits with an ellipsis.
std::string fitted(const std::string& text, float width) {
    if (text_width(text) <= width) return text;
    std::u32string codes = code_points(text);
    while (!codes.empty() && text_width(encode_utf8(codes) + "\u2026") > width) codes.pop_back();
    return encode_utf8(codes) + "\u2026";
}

// Text on a dark plate.
void plate(const std::string& text, ImVec2 at) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 padding(ImGui::GetFontSize() * 0.4f, ImGui::GetFontSize() * 0.2f);
    const ImVec2 end(at.x + text_width(text) + 2 * padding.x, at.y + ImGui::GetFontSize() + 2 * padding.y);
    list.AddRectFilled(at, end, ImGui::GetColorU32(ImVec4(0, 0, 0, 0.5f)), ImGui::GetStyle().FrameRounding);
    list.AddText({at.x + padding.x, at.y + padding.y}, ImGui::GetColorU32(palette::text), text.c_str());
}

float divider_x(double divider, ImVec2 corner, ImVec2 size) {
    return corner.x + static_cast<float>(divider) * size.x;
}

}  // namespace

void divider_handle(double& divider, ImVec2 corner, ImVec2 size) {
    const ImVec2 before = ImGui::GetCursorScreenPos();
    const float half = ImGui::GetFontSize() * reach;
    // Within the area also where the line stands at its edge.
    const float left = std::clamp(divider_x(divider, corner, size) - half, corner.x,
                                  std::max(corner.x + size.x - 2 * half, corner.x));
    ImGui::SetCursorScreenPos({left, corner.y});
    ImGui::InvisibleButton("Divider", {2 * half, size.y});
    note_item("Divider");
    if (ImGui::IsItemHovered() || ImGui::IsItemActive()) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    if (!ImGui::IsItemActive())
        tooltip_for_item("Drag to show more of one side. A double click: the middle.");
    if (ImGui::IsItemActive() && ImGui::GetIO().MouseDelta.x != 0)
        divider = std::clamp(static_cast<double>((ImGui::GetIO().MousePos.x - corner.x) / size.x), 0.0, 1.0);
    if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) divider = 0.5;
    ImGui::SetCursorScreenPos(before);
}

void draw_divider(double divider, ImVec2 corner, ImVec2 size) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float x = std::clamp(divider_x(divider, corner, size), corner.x + 1, corner.x + size.x - 1);
    const float middle = corner.y + 0.5f * size.y, grip = ImGui::GetFontSize() * 0.55f;
    const ImU32 colour = ImGui::GetColorU32(palette::text);
    list.AddLine({x, corner.y}, {x, corner.y + size.y}, ImGui::GetColorU32(ImVec4(0, 0, 0, 0.4f)), 3);
    list.AddLine({x, corner.y}, {x, corner.y + size.y}, colour, 1);
    for (const float side : {-1.0f, 1.0f})
        list.AddTriangleFilled({x + side * 1.6f * grip, middle}, {x + side * 0.6f * grip, middle - grip},
                               {x + side * 0.6f * grip, middle + grip}, colour);
}

void side_labels(const std::string& left, const std::string& right, ImVec2 corner, ImVec2 size) {
    const float margin = ImGui::GetFontSize() * 0.5f;
    const float most = 0.5f * size.x - 2 * margin - ImGui::GetFontSize() * 0.8f;
    if (most < 2 * ImGui::GetFontSize()) return;
    plate(fitted(left, most), {corner.x + margin, corner.y + margin});
    if (right.empty()) return;
    const std::string text = fitted(right, most);
    plate(text,
          {corner.x + size.x - margin - text_width(text) - ImGui::GetFontSize() * 0.8f, corner.y + margin});
}

void scale_legend(const ScaleLegend& legend, ImVec2 corner, ImVec2 size) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float letter = ImGui::GetFontSize(), margin = letter * 0.5f;
    const float width = std::min(letter * 9, size.x - 4 * margin);
    if (width < 4 * letter || size.y < 8 * letter) return;
    const ImVec2 low(corner.x + 2 * margin, corner.y + size.y - 2 * margin - 2.4f * letter);
    list.AddRectFilled({low.x - margin, low.y - margin - letter * 1.2f},
                       {low.x + width + margin, low.y + 1.8f * letter + margin},
                       ImGui::GetColorU32(ImVec4(0, 0, 0, 0.5f)), ImGui::GetStyle().FrameRounding);
    const ImU32 text = ImGui::GetColorU32(palette::text);
    list.AddText({low.x, low.y - letter * 1.2f}, text, legend.title.c_str());
    for (int i = 0; i < bar_steps; ++i) {
        const float step = width / bar_steps, x = low.x + step * static_cast<float>(i);
        list.AddRectFilled({x, low.y}, {x + step + 0.5f, low.y + 0.6f * letter},
                           legend.colour(static_cast<float>(i) / (bar_steps - 1)));
    }
    list.AddText({low.x, low.y + 0.8f * letter}, text, legend.low.c_str());
    list.AddText({low.x + width - text_width(legend.high), low.y + 0.8f * letter}, text, legend.high.c_str());
}

}  // namespace nacre::ui
