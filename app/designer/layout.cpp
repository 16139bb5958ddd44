#include "app/designer/layout.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "ui/item_map.h"
#include "ui/status_line.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace nacre {
namespace {

constexpr float panel_max_part = 0.4f;  // of the window's width
constexpr float grip_ems = 0.55f;       // width of what takes hold of a border, text sizes
constexpr float drawer_max = 0.6f;      // of the height above the status line
constexpr float history_part = 0.36f;   // of the panel's height
constexpr ImGuiWindowFlags fixed = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove |
                                   ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse |
                                   ImGuiWindowFlags_NoSavedSettings;
// Lies beneath what does not have this flag.
constexpr ImGuiWindowFlags beneath = ImGuiWindowFlags_NoBringToFrontOnFocus;

constexpr const char* canvas_window = "CanvasColumn";
constexpr const char* preview_window = "PreviewColumn";

void draw_column(const char* name, const PartBox& column, const std::function<void()>& contents) {
    ImGui::SetNextWindowPos(ImVec2(column.left, column.top));
    ImGui::SetNextWindowSize(ImVec2(column.width, column.height));
    ImGui::Begin(name, nullptr, fixed | beneath);
    contents();
    ImGui::End();
}

// A column that a picture fills to its edges.
void draw_picture_column(const char* name, const PartBox& column, const std::function<void()>& contents) {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
    // The session has cleared the window to the canvas's colour: filling it once more takes time in vain.
    ImGui::PushStyleColor(ImGuiCol_WindowBg, ui::Colour{0, 0, 0, 0});
    draw_column(name, column, [&] {
        ImGui::PopStyleVar();
        contents();
        ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
    });
    ImGui::PopStyleColor();
    ImGui::PopStyleVar();
}

// The border at the left of a picture column: where it is dragged to, or `usual` by a double click.
std::optional<float> draw_border(const char* name, const PartBox& column, float usual) {
    const float width = std::round(grip_ems * ImGui::GetFontSize());
    ImGui::SetNextWindowPos(ImVec2(column.left, column.top));
    ImGui::SetNextWindowSize(ImVec2(width, column.height));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1, 1));
    ImGui::Begin(name, nullptr,
                 fixed | ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoScrollbar |
                     ImGuiWindowFlags_NoFocusOnAppearing);
    ImGui::PopStyleVar(2);
    ImGui::InvisibleButton(name, ImVec2(width, column.height));
    ui::note_part(name, ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
    ui::tooltip_for_item("Drag to give one side more room; a double click sets it back.");
    std::optional<float> moved;
    if (ImGui::IsItemActive() && ImGui::GetIO().MouseDelta.x != 0)
        moved = ImGui::GetIO().MousePos.x - width / 2;
    if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) moved = usual;
    if (ImGui::IsItemHovered() || ImGui::IsItemActive()) {
        ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
        const float line = std::max(1.0f, std::round(ImGui::GetFontSize() / 8));
        ImGui::GetWindowDrawList()->AddRectFilled(
            ImVec2(column.left, column.top), ImVec2(column.left + line, column.top + column.height),
            ImGui::GetColorU32(ImGui::IsItemActive() ? ui::palette::accent : ui::palette::line));
    }
    ImGui::End();
    return moved;
}

// The border above the drawer. Returns by how much it was dragged up.
float drawer_border(float left, float top, float width) {
    const float reach = std::round(ImGui::GetFontSize() * 0.35f);
    ImGui::SetCursorScreenPos({left, top});
    ImGui::InvisibleButton("drawer border", {width, reach});
    ui::note_part("Plots border", ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
    ui::tooltip_for_item("Drag to give the plots more room.");
    const bool held = ImGui::IsItemActive();
    if (held || ImGui::IsItemHovered()) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeNS);
    const ImVec4 colour = held || ImGui::IsItemHovered() ? ui::palette::accent : ui::palette::line;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.PushClipRect({left, top}, {left + width, top + reach});
    list.AddLine({left, top + 1}, {left + width, top + 1}, ImGui::GetColorU32(colour),
                 std::max(1.0f, reach * 0.25f));
    list.PopClipRect();
    return held ? -ImGui::GetIO().MouseDelta.y : 0;
}

// Of `height`, which canvas and preview share with the drawer.
float drawer_height(const Layout& layout, float height) {
    const float size = ImGui::GetFontSize(), most = std::round(height * drawer_max);
    return std::clamp(std::round(layout.drawer * size), std::min(drawer_min * size, most), most);
}

void draw_drawer(Layout& layout, const PartBox& column, const std::function<void()>& contents) {
    ImGui::SetNextWindowPos({column.left, column.top});
    ImGui::SetNextWindowSize({column.width, column.height});
    // In front of the columns, whose own borders would else take the pointer a few pixels below them.
    constexpr ImGuiWindowFlags flags =
        fixed | ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse;
    ImGui::Begin("Drawer", nullptr, flags);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float up = drawer_border(column.left, column.top, column.width);
    if (up != 0) layout.drawer = std::max((column.height + up) / ImGui::GetFontSize(), drawer_min);
    ImGui::SetCursorScreenPos(corner);
    contents();
    ImGui::End();
}

// More of a window that has been begun in this frame.
void draw_more(const char* name, const std::function<void()>& contents) {
    ImGui::Begin(name, nullptr, fixed | beneath);
    contents();
    ImGui::End();
}

float panel_width(float ems, float window) {
    return std::min(std::round(ems * ImGui::GetFontSize()), std::max(window * panel_max_part, 1.0f));
}

void draw_status(const PartBox& place, const std::function<void()>& contents) {
    ImGui::SetNextWindowPos(ImVec2(place.left, place.top));
    ImGui::SetNextWindowSize(ImVec2(place.width, place.height));
    ImGui::PushStyleColor(ImGuiCol_WindowBg, ImGui::GetColorU32(ImGuiCol_MenuBarBg));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding,
                        ImVec2(ImGui::GetStyle().WindowPadding.x, ImGui::GetFontSize() * 0.42f));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1, 1));
    ImGui::Begin("Status", nullptr, fixed | beneath | ImGuiWindowFlags_NoScrollbar);
    ImGui::PopStyleVar(2);
    contents();
    ImGui::End();
    ImGui::PopStyleColor();
}

void draw_borders(Layout& layout, const Places& places) {
    const Layout usual;
    const float panel = places.canvas.left, window = places.status.width;
    const float beside = std::max(window - panel, 2.0f);
    if (places.panel)
        if (const auto x = draw_border("Panel border", places.canvas, panel_width(usual.panel, window)))
            layout.panel = std::clamp(*x / ImGui::GetFontSize(), panel_min, panel_max);
    if (const auto x = draw_border("Canvas border", places.preview, panel + beside * usual.canvas))
        layout.canvas = std::clamp((*x - panel) / beside, canvas_min, canvas_max);
}

}  // namespace

Places place_parts(const Layout& layout, const Shown& shown) {
    const ImVec2 window = ImGui::GetMainViewport()->Size;
    const float top = ImGui::GetFrameHeight(), bottom = ui::status_height();
    const float height = std::max(window.y - top - bottom, 1.0f);
    const float panel = shown.panel ? panel_width(layout.panel, window.x) : 0;
    const float beside = std::max(window.x - panel, 2.0f);
    const float width = std::round(beside * std::clamp(layout.canvas, canvas_min, canvas_max));
    const float below = shown.drawer ? drawer_height(layout, height) : 0, upper = height - below;
    Places places{.panel = {},
                  .drawer = {},
                  .history = {},
                  .canvas = {panel, top, width, upper},
                  .preview = {panel + width, top, std::max(beside - width, 1.0f), upper},
                  .status = {0, window.y - bottom, window.x, bottom}};
    const float past = shown.panel && shown.history ? std::round(height * history_part) : 0;
    if (shown.panel) places.panel = PartBox{0, top, panel, height - past};
    if (past > 0) places.history = PartBox{0, top + height - past, panel, past};
    if (shown.drawer) places.drawer = PartBox{panel, top + upper, beside, below};
    return places;
}

void take_input(const Places& places, const InputParts& parts) {
    if (places.panel) draw_column("Panel", *places.panel, parts.panel);
    if (places.history) draw_column("History", *places.history, parts.history);
    draw_picture_column(canvas_window, places.canvas, parts.canvas);
    draw_picture_column(preview_window, places.preview, parts.preview);
}

void draw_parts(Layout& layout, const Places& places, const DrawnParts& parts) {
    draw_more(canvas_window, parts.canvas);
    draw_more(preview_window, parts.preview);
    if (places.drawer) draw_drawer(layout, *places.drawer, parts.drawer);
    draw_borders(layout, places);
    draw_status(places.status, parts.status);
}

}  // namespace nacre
