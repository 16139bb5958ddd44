#include "app/designer/layout.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "ui/status_line.h"
#include "ui/theme.h"

namespace nacre {
namespace {

constexpr float panel_most = 0.4f;                        // of the window's breadth
constexpr float canvas_least = 0.2f, canvas_most = 0.8f;  // of the breadth beside the panel
constexpr float canvas_usual = 0.5f;
constexpr ImGuiWindowFlags fixed = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove |
                                   ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings |
                                   ImGuiWindowFlags_NoBringToFrontOnFocus;

// The breadths that the right border of a column can be dragged to.
struct Breadth {
    float now, least, most;
};

// A column of the window. Returns its breadth.
float column(const char* name, float left, float top, float height, const Breadth& breadth,
             const std::function<void()>& contents) {
    ImGui::SetNextWindowPos(ImVec2(left, top));
    ImGui::SetNextWindowSize(ImVec2(breadth.now, height),
                             ImGui::IsAnyMouseDown() ? ImGuiCond_Once : ImGuiCond_Always);
    ImGui::SetNextWindowSizeConstraints(ImVec2(breadth.least, height), ImVec2(breadth.most, height));
    ImGui::Begin(name, nullptr, fixed | ImGuiWindowFlags_NoScrollWithMouse * (breadth.least == breadth.most));
    contents();
    const float now = ImGui::GetWindowWidth();
    ImGui::End();
    return now;
}

// A column that a picture fills to its edges.
float picture_column(const char* name, float left, float top, float height, const Breadth& breadth,
                     const std::function<void()>& contents) {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
    // The session has cleared the window to the canvas's colour: filling it once more takes time in vain.
    ImGui::PushStyleColor(ImGuiCol_WindowBg, ui::Colour{0, 0, 0, 0});
    const float now = column(name, left, top, height, breadth, [&] {
        ImGui::PopStyleVar();
        contents();
        ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
    });
    ImGui::PopStyleColor();
    ImGui::PopStyleVar();
    return now;
}

}  // namespace

void draw_layout(Layout& layout, const Parts& parts) {
    const ImVec2 window = ImGui::GetMainViewport()->Size;
    const float top = ImGui::GetFrameHeight();
    const float bottom = ui::status_height();
    const float height = std::max(window.y - top - bottom, 1.0f);
    if (layout.panel <= 0) {
        layout.panel = ui::panel_width();
        layout.canvas = canvas_usual;
    }
    const float most = std::max(window.x * panel_most, 1.0f);
    const Breadth panel{layout.panel, std::min(ui::panel_width() * 0.8f, most), most};
    layout.panel = column("Panel", 0, top, height, panel, parts.panel);
    const float beside = std::max(window.x - layout.panel, 2.0f);
    const Breadth canvas{std::round(beside * layout.canvas), beside * canvas_least, beside * canvas_most};
    const float breadth = picture_column("CanvasColumn", layout.panel, top, height, canvas, parts.canvas);
    if (std::abs(breadth - canvas.now) > 0.5f) layout.canvas = breadth / beside;
    const float left = layout.panel + breadth, rest = std::max(window.x - left, 1.0f);
    picture_column("PreviewColumn", left, top, height, {rest, rest, rest}, parts.preview);

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
