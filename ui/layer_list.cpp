#include "ui/layer_list.h"

#include <imgui.h>
#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "ui/edit_name.h"
#include "ui/escape.h"
#include "ui/focus.h"
#include "ui/item_map.h"
#include "ui/list_row.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace nacre::ui {
namespace {

using Layers = std::vector<Layer>;

constexpr float line_gap = 3;  // pixels between two lines

std::string name_of(std::size_t index) { return "Layer " + std::to_string(index + 1); }

float line_pitch() { return ImGui::GetFrameHeight() + line_gap; }

double total_weight(const Layers& layers) {
    double sum = 0;
    for (const Layer& layer : layers)
        if (layer.enabled) sum += layer.weight;
    return sum;
}

std::string share_text(const Layer& layer, double total) {
    if (!layer.enabled || total <= 0) return "\u2013";
    char text[32];
    std::snprintf(text, sizeof(text), "%.3g %%", 100 * layer.weight / total);
    return text;
}

// The chosen layer goes to another place; those between make room.
void move_layer(LayersView& view, Layers& layers, std::size_t to) {
    const auto at = [&](std::size_t index) { return layers.begin() + static_cast<std::ptrdiff_t>(index); };
    if (to > view.chosen)
        std::rotate(at(view.chosen), at(view.chosen) + 1, at(to) + 1);
    else
        std::rotate(at(to), at(view.chosen), at(view.chosen) + 1);
    view.chosen = to;
    view.solo.reset();
}

// Shows a layer alone, or all of them again.
void solo_button(LayersView& view, std::size_t index) {
    const bool alone = view.solo == index;
    ImGui::PushStyleColor(ImGuiCol_Button, alone ? ImVec4(palette::accent_dim) : ImVec4(0, 0, 0, 0));
    ImGui::PushStyleColor(ImGuiCol_Text, alone ? palette::accent_bright : palette::text_dim);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(0, ImGui::GetStyle().FramePadding.y));
    if (ImGui::Button("S", ImVec2(ImGui::GetFrameHeight(), 0)))
        view.solo = alone ? std::nullopt : std::optional(index);
    ImGui::PopStyleVar();
    ImGui::PopStyleColor(2);
    note_item(name_of(index) + " solo");
    tooltip_for_item("Show this layer alone. The design stays as it is.");
}

const char* title_of(const Layer& layer) {
    return layer.name.empty() ? kind_label(layer.lobe) : layer.name.c_str();
}

// The name as a field, until Enter, Escape or a click elsewhere.
bool name_field(LayersView& view, Layer& layer, std::size_t index, float width) {
    LayersView::Rename& rename = *view.rename;
    if (!rename.begun) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(width);
    const bool changed = ImGui::InputTextWithHint("##name", kind_label(layer.lobe), &layer.name,
                                                  ImGuiInputTextFlags_AutoSelectAll);
    note_item(name_of(index) + " name");
    const bool elsewhere = ImGui::IsMouseClicked(ImGuiMouseButton_Left) && !ImGui::IsItemHovered();
    if ((rename.begun && !ImGui::IsItemActive()) || elsewhere)
        view.rename.reset();
    else
        rename.begun |= ImGui::IsItemActive();
    return changed;
}

// Of the last item.
LayerAction context_menu(std::size_t index, std::size_t count) {
    if (!begin_second_menu("menu")) return LayerAction::none;
    LayerAction wanted = LayerAction::none;
    // The lines of the list stand closer than those of a menu.
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing,
                        ImVec2(ImGui::GetStyle().ItemSpacing.x, ImGui::GetFontSize() * 0.5f));
    const auto entry = [&](const char* label, LayerAction action, const char* step) {
        if (ImGui::MenuItem(label, nullptr, false, possible(action, index, count))) {
            wanted = action;
            name_edit(step);
        }
        note_item(std::string("Menu ") + label);
    };
    entry("Cut", LayerAction::cut, "Cut layer");
    entry("Copy", LayerAction::copy, "Copy layer");
    entry("Paste", LayerAction::paste, "Paste layer");
    ImGui::Separator();
    entry("Rename", LayerAction::rename, "Rename layer");
    entry("Duplicate", LayerAction::duplicate, "Duplicate layer");
    entry("Delete", LayerAction::remove, "Delete layer");
    ImGui::Separator();
    entry("Move up", LayerAction::up, "Layer up");
    entry("Move down", LayerAction::down, "Layer down");
    ImGui::PopStyleVar();
    ImGui::EndPopup();
    return wanted;
}

LayerAction name_row(LayersView& view, std::size_t index, std::size_t count, const ListRow& row) {
    list_row(name_of(index).c_str(), row);
    tooltip_for_item("A double click renames, a drag changes the order. The order has no bearing on p.");
    const bool right = ImGui::IsItemHovered() && ImGui::IsMouseClicked(ImGuiMouseButton_Right);
    if (ImGui::IsItemActivated() || right) view.chosen = index;
    if (ImGui::IsItemActive() && ImGui::IsMouseDragging(ImGuiMouseButton_Left)) view.carried = true;
    const bool twice = ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
    const LayerAction wanted = context_menu(index, count);
    return twice ? LayerAction::rename : wanted;
}

// One line of the list: on or off, a picture, the name, the share of facet area, solo.
bool layer_line(LayersView& view, Layers& layers, std::size_t index, double total, LayerAction& wanted) {
    Layer& layer = layers[index];
    ImGui::PushID(static_cast<int>(index));
    bool changed = ImGui::Checkbox("##enabled", &layer.enabled);
    note_item(name_of(index) + " enabled");
    tooltip_for_item("Leave this layer in or out.");
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x, side = ImGui::GetFrameHeight();
    ImGui::SameLine(0, gap);
    view.thumbnails.draw(index, ImGui::GetCursorScreenPos(), side);
    ImGui::Dummy(ImVec2(side, side));
    ImGui::SameLine(0, gap);
    if (view.rename && view.rename->layer == index) {
        changed |= name_field(view, layer, index, ImGui::GetContentRegionAvail().x - side - gap);
    } else {
        const LayerAction action =
            name_row(view, index, layers.size(),
                     {.text = title_of(layer),
                      .at_right = share_text(layer, total),
                      .chosen = view.chosen == index,
                      .dimmed = !layer.enabled || (view.carried && view.chosen == index),
                      .free_at_right = side + gap});
        if (action != LayerAction::none) wanted = action;
    }
    ImGui::SameLine(0, gap);
    solo_button(view, index);
    ImGui::PopID();
    return changed;
}

// A list that is longer than the panel follows the pointer.
void scroll_to_pointer() {
    const float size = ImGui::GetFontSize(), y = ImGui::GetIO().MousePos.y;
    const float top = ImGui::GetWindowPos().y, bottom = top + ImGui::GetWindowHeight();
    if (y < top + size) ImGui::SetScrollY(std::max(ImGui::GetScrollY() - size / 3, 0.0f));
    if (y > bottom - size)
        ImGui::SetScrollY(std::min(ImGui::GetScrollY() + size / 3, ImGui::GetScrollMaxY()));
}

// The line between two layers where the carried one would go, and its name at the pointer.
void draw_carried(const Layer& layer, ImVec2 corner, std::size_t slot) {
    const float scale = ImGui::GetFontSize() / 15, right = corner.x + ImGui::GetContentRegionAvail().x;
    const float y = corner.y + static_cast<float>(slot) * line_pitch() - line_gap / 2;
    ImDrawList& list = *ImGui::GetForegroundDrawList();
    const ImU32 ink = ImGui::GetColorU32(palette::accent_bright);
    list.AddLine({corner.x, y}, {right, y}, ink, 2 * scale);
    list.AddCircleFilled({corner.x, y}, 3.5f * scale, ink);
    const ImVec2 mouse = ImGui::GetIO().MousePos, padding = ImGui::GetStyle().FramePadding;
    const ImVec2 low(mouse.x + 12 * scale, mouse.y + 4 * scale);
    const ImVec2 extent = ImGui::CalcTextSize(title_of(layer));
    list.AddRectFilled(low, {low.x + extent.x + 2 * padding.x, low.y + extent.y + 2 * padding.y},
                       ImGui::GetColorU32(palette::accent_dim), ImGui::GetStyle().FrameRounding);
    list.AddText({low.x + padding.x, low.y + padding.y}, ImGui::GetColorU32(palette::text), title_of(layer));
}

// The chosen layer is held by its line. Escape lets it go where it was.
bool carry(LayersView& view, Layers& layers, ImVec2 corner) {
    const float line = std::round((ImGui::GetIO().MousePos.y - corner.y) / line_pitch());
    const auto slot = static_cast<std::size_t>(std::clamp(line, 0.0f, static_cast<float>(layers.size())));
    if (take_escape_of_drag()) {
        view.carried = false;
        return false;
    }
    if (ImGui::IsMouseDown(ImGuiMouseButton_Left)) {
        draw_carried(layers[view.chosen], corner, slot);
        scroll_to_pointer();
        return false;
    }
    view.carried = false;
    const std::size_t to = slot > view.chosen ? slot - 1 : slot;
    if (to == view.chosen) return false;
    move_layer(view, layers, to);
    name_edit("Move layer");
    return true;
}

}  // namespace

bool possible(LayerAction action, std::size_t layer, std::size_t count) {
    switch (action) {
        case LayerAction::none:
        case LayerAction::rename:
        case LayerAction::copy:
            return layer < count;
        case LayerAction::paste:
            return count < std::size_t{limits::layers_max};
        case LayerAction::duplicate:
            return layer < count && count < std::size_t{limits::layers_max};
        case LayerAction::cut:
        case LayerAction::remove:
            return layer < count && count > 1;
        case LayerAction::up:
            return layer < count && layer > 0;
        case LayerAction::down:
            return layer + 1 < count;
    }
    return false;
}

bool act(LayerAction action, LayersView& view, Layers& layers) {
    if (!possible(action, view.chosen, layers.size())) return false;
    const auto chosen = layers.begin() + static_cast<std::ptrdiff_t>(view.chosen);
    switch (action) {
        case LayerAction::none:
            return false;
        case LayerAction::rename:
            view.rename = LayersView::Rename{.layer = view.chosen};
            return false;
        case LayerAction::duplicate:
            layers.insert(chosen + 1, Layer(*chosen));
            ++view.chosen;
            return true;
        case LayerAction::remove:
            layers.erase(chosen);
            view.chosen = std::min(view.chosen, layers.size() - 1);
            return true;
        case LayerAction::up:
            move_layer(view, layers, view.chosen - 1);
            return true;
        case LayerAction::down:
            move_layer(view, layers, view.chosen + 1);
            return true;
        case LayerAction::cut:
            view.asked = ClipboardAction::cut;
            return false;
        case LayerAction::copy:
            view.asked = ClipboardAction::copy;
            return false;
        case LayerAction::paste:
            view.asked = ClipboardAction::paste;
            return false;
    }
    return false;
}

bool layer_list(LayersView& view, Layers& layers) {
    bool changed = false;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const double total = total_weight(layers);
    LayerAction wanted = LayerAction::none;
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ImGui::GetStyle().ItemSpacing.x, line_gap));
    for (std::size_t i = 0; i < layers.size(); ++i) changed |= layer_line(view, layers, i, total, wanted);
    ImGui::PopStyleVar();
    if (view.carried && !layers.empty()) changed |= carry(view, layers, corner);
    return act(wanted, view, layers) || changed;
}

}  // namespace nacre::ui
