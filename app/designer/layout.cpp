#include "app/designer/layout.h"

#include <imgui.h>

#include <algorithm>

#include "ui/status_line.h"
#include "ui/theme.h"

namespace nacre {
namespace {

constexpr float share_most = 0.32f;  // of the window's breadth for one side panel: the picture stays largest
constexpr ImGuiWindowFlags fixed = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove |
                                   ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings |
                                   ImGuiWindowFlags_NoBringToFrontOnFocus;

// A side panel: its inner border can be dragged. Returns its breadth.
float side_panel(const char* name, bool at_right, float breadth, float top, float height,
                 const std::function<void()>& contents) {
    const float window = ImGui::GetMainViewport()->Size.x;
    const float most = std::max(window * share_most, 1.0f);
    const float least = std::min(ui::panel_width() * 0.8f, most);
    ImGui::SetNextWindowPos(ImVec2(at_right ? window : 0, top), ImGuiCond_Always,
                            ImVec2(at_right ? 1.0f : 0.0f, 0));
    ImGui::SetNextWindowSize(ImVec2(breadth, height), ImGuiCond_Once);
    ImGui::SetNextWindowSizeConstraints(ImVec2(least, height), ImVec2(most, height));
    ImGui::Begin(name, nullptr, fixed);
    contents();
    const float now = ImGui::GetWindowWidth();
    ImGui::End();
    return now;
}

}  // namespace

void draw_layout(Layout& layout, const Parts& parts) {
    const ImVec2 window = ImGui::GetMainViewport()->Size;
    const float top = ImGui::GetFrameHeight();
    const float bottom = ui::status_height();
    const float height = std::max(window.y - top - bottom, 1.0f);
    if (layout.left <= 0) layout.left = layout.right = ui::panel_width();
    layout.left = side_panel("Left", false, layout.left, top, height, parts.left);
    layout.right = side_panel("Right", true, layout.right, top, height, parts.right);

    ImGui::SetNextWindowPos(ImVec2(layout.left, top));
    ImGui::SetNextWindowSize(ImVec2(std::max(window.x - layout.left - layout.right, 1.0f), height));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
    ImGui::PushStyleColor(ImGuiCol_WindowBg, ui::palette::canvas);
    ImGui::Begin("Centre", nullptr,
                 fixed | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoScrollbar |
                     ImGuiWindowFlags_NoScrollWithMouse);
    ImGui::PopStyleVar();
    parts.centre();
    ImGui::End();
    ImGui::PopStyleColor();

    ImGui::SetNextWindowPos(ImVec2(0, window.y - bottom));
    ImGui::SetNextWindowSize(ImVec2(window.x, bottom));
    ImGui::PushStyleColor(ImGuiCol_WindowBg, ImGui::GetColorU32(ImGuiCol_MenuBarBg));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding,
                        ImVec2(ImGui::GetStyle().WindowPadding.x, ImGui::GetFontSize() * 0.42f));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1, 1));
    ImGui::Begin("Status", nullptr, fixed | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoScrollbar);
    ImGui::PopStyleVar(2);
    parts.status();
    ImGui::End();
    ImGui::PopStyleColor();
}

}  // namespace nacre
