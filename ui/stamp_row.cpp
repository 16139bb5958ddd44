#include "ui/stamp_row.h"

#include <algorithm>
#include <string>

#include "ui/item_map.h"
#include "ui/stamp_picture.h"
#include "ui/theme.h"
#include "ui/toolbar_fields.h"
#include "ui/widgets.h"

namespace nacre::ui {
namespace {

constexpr const char* palette_name = "Stamps";
constexpr int per_row = 4;
constexpr float tile_ems = 4.6f;

// A tile with its name below. Returns whether it was pressed.
bool tile(const NamedStamp& stamp, bool chosen) {
    const float side = ImGui::GetFontSize() * tile_ems, line = ImGui::GetTextLineHeight();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const std::string label = as_label(stamp.name);
    const bool pressed = ImGui::InvisibleButton(label.c_str(), {side, side + line});
    note_item("Stamp " + label);
    tooltip_for_item(label.c_str());
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const Colour back = chosen                   ? palette::accent_dim
                        : ImGui::IsItemHovered() ? palette::field
                                                 : palette::canvas;
    list.AddRectFilled(corner, {corner.x + side, corner.y + side + line}, ImGui::GetColorU32(back),
                       ImGui::GetStyle().FrameRounding);
    const float border = scaled(4);
    draw_stamp(*stamp.thumbnail, {corner.x + border, corner.y + border}, side - 2 * border, palette::text);
    const ImVec4 clip(corner.x, corner.y, corner.x + side, corner.y + side + line);
    const float width = std::min(ImGui::CalcTextSize(label.c_str()).x, side - 2 * border);
    list.AddText(ImGui::GetFont(), ImGui::GetFontSize(),
                 {corner.x + (side - width) / 2, corner.y + side - border},
                 ImGui::GetColorU32(chosen ? palette::accent_bright : palette::text_dim), label.c_str(),
                 nullptr, 0, &clip);
    return pressed;
}

void stamp_palette(CanvasState& state) {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(scaled(8), scaled(8)));
    const bool open = ImGui::BeginPopup(palette_name);
    ImGui::PopStyleVar();
    if (!open) return;
    for (std::size_t i = 0; i < state.stamps.size(); ++i) {
        if (i % per_row != 0) ImGui::SameLine();
        ImGui::PushID(static_cast<int>(i));
        if (tile(state.stamps[i], i == state.stamp)) {
            state.stamp = i;
            ImGui::CloseCurrentPopup();
        }
        ImGui::PopID();
    }
    if (button(
            "Load\u2026##Load stamp",
            "A picture of your own: PNG, SVG or any other. White paints, and dark where the ground is white "
            "or transparent.")) {
        state.asks_for_stamp = true;
        ImGui::CloseCurrentPopup();
    }
    ImGui::EndPopup();
}

void picture_button(CanvasState& state, float width) {
    const NamedStamp& stamp = state.stamps[state.stamp];
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float side = ImGui::GetFrameHeight();
    if (ImGui::Button("##Stamp picture", {width, side})) ImGui::OpenPopup(palette_name);
    note_item("Stamp picture");
    tooltip_for_item("The picture to stamp with.");
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float border = scaled(2);
    draw_stamp(*stamp.thumbnail, {corner.x + border, corner.y + border}, side - 2 * border, palette::text);
    const std::string label = as_label(stamp.name);
    const ImVec4 clip(corner.x, corner.y, corner.x + width - border, corner.y + side);
    list.AddText(ImGui::GetFont(), ImGui::GetFontSize(),
                 {corner.x + side + border, corner.y + ImGui::GetStyle().FramePadding.y},
                 ImGui::GetColorU32(palette::text), label.c_str(), nullptr, 0, &clip);
}

}  // namespace

void add_stamp(ToolbarRow& row, CanvasState& state, float width) {
    row.add(width, [&state, width] {
        picture_button(state, width);
        stamp_palette(state);
    });
    row.add(width, [&state, width] {
        bar({.label = "Stamp angle",
             .low = -180,
             .high = 180,
             .least = -360,
             .most = 360,
             .reset = 0,
             .format = "Turn %.0f\u00b0",
             .logarithmic = false,
             .tooltip = "Turns the stamp, counterclockwise."},
            width, state.pose.angle);
    });
    row.add(button_width("Flip"), [&state] {
        ImGui::PushStyleColor(ImGuiCol_Button, state.pose.flip ? palette::accent_dim : palette::field);
        if (button("Flip##Flip stamp", "Left and right of the stamp change places."))
            state.pose.flip = !state.pose.flip;
        ImGui::PopStyleColor();
    });
}

}  // namespace nacre::ui
