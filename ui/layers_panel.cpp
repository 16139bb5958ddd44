#include "ui/layers_panel.h"

#include <imgui.h>

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <string>
#include <utility>

#include "ui/item_map.h"
#include "ui/list_row.h"
#include "ui/lobe_kinds.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace nacre::ui {
namespace {

using Layers = std::vector<Layer>;

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
    note_item("Layer " + std::to_string(index + 1) + " solo");
    tooltip_for_item("Show this layer alone. The design stays as it is.");
}

// One line of the list: on or off, a picture, the name, the share of facet area, solo.
bool layer_line(LayersView& view, Layers& layers, std::size_t index, double total, bool& dragged) {
    Layer& layer = layers[index];
    ImGui::PushID(static_cast<int>(index));
    bool changed = ImGui::Checkbox("##enabled", &layer.enabled);
    note_item("Layer " + std::to_string(index + 1) + " enabled");
    tooltip_for_item("Leave this layer in or out.");
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x, side = ImGui::GetFrameHeight();
    ImGui::SameLine(0, gap);
    view.thumbnails.draw(index, ImGui::GetCursorScreenPos(), side);
    ImGui::Dummy(ImVec2(side, side));
    ImGui::SameLine(0, gap);
    list_row(("Layer " + std::to_string(index + 1)).c_str(), {.text = layer_title(layer),
                                                              .at_right = share_text(layer, total),
                                                              .chosen = view.chosen == index,
                                                              .dimmed = !layer.enabled,
                                                              .free_at_right = side + gap});
    if (ImGui::IsItemActivated()) view.chosen = index;
    dragged |= ImGui::IsItemActive() && ImGui::IsMouseDragging(ImGuiMouseButton_Left);
    ImGui::SameLine(0, gap);
    solo_button(view, index);
    ImGui::PopID();
    return changed;
}

void move_layer(LayersView& view, Layers& layers, std::size_t to) {
    const auto at = [&](std::size_t index) { return layers.begin() + static_cast<std::ptrdiff_t>(index); };
    if (to > view.chosen)
        std::rotate(at(view.chosen), at(view.chosen) + 1, at(to) + 1);
    else
        std::rotate(at(to), at(view.chosen), at(view.chosen) + 1);
    view.chosen = to;
    view.solo.reset();
}

// The list; a dragged line goes where the pointer is.
bool layer_lines(LayersView& view, Layers& layers) {
    bool changed = false;
    bool dragged = false;
    constexpr float gap = 3;
    const float top = ImGui::GetCursorScreenPos().y;
    const double total = total_weight(layers);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ImGui::GetStyle().ItemSpacing.x, gap));
    for (std::size_t i = 0; i < layers.size(); ++i) changed |= layer_line(view, layers, i, total, dragged);
    ImGui::PopStyleVar();
    if (dragged) {
        const float line = (ImGui::GetIO().MousePos.y - top) / (ImGui::GetFrameHeight() + gap);
        const auto to =
            static_cast<std::size_t>(std::clamp(line, 0.0f, static_cast<float>(layers.size() - 1)));
        if (to != view.chosen) {
            move_layer(view, layers, to);
            changed = true;
        }
    }
    return changed;
}

bool add_button(LayersView& view, Layers& layers) {
    bool changed = false;
    const bool room = layers.size() < limits::layers_max;
    if (button("+ Add##Add layer", "Add a layer of any kind.", room)) ImGui::OpenPopup("kinds");
    if (!ImGui::BeginPopup("kinds")) return false;
    for (std::size_t kind = 0; kind < lobe_names().size(); ++kind) {
        const bool pressed = ImGui::MenuItem(lobe_names()[kind]);
        note_item(std::string("Add ") + lobe_names()[kind]);
        tooltip_for_item(lobe_explanation(kind));
        if (!pressed) continue;
        Layer layer;
        layer.lobe = default_lobe(kind);
        layers.push_back(std::move(layer));
        view.chosen = layers.size() - 1;
        changed = true;
    }
    ImGui::EndPopup();
    return changed;
}

bool list_buttons(LayersView& view, Layers& layers) {
    bool changed = add_button(view, layers);
    const bool any = !layers.empty();
    ImGui::SameLine();
    if (button("Duplicate##Duplicate layer", "A copy of the chosen layer, after it.",
               any && layers.size() < limits::layers_max)) {
        layers.insert(layers.begin() + static_cast<std::ptrdiff_t>(view.chosen) + 1,
                      Layer(layers[view.chosen]));
        ++view.chosen;
        changed = true;
    }
    ImGui::SameLine();
    if (button("Delete##Delete layer", "Remove the chosen layer. A design needs at least one.",
               layers.size() > 1)) {
        layers.erase(layers.begin() + static_cast<std::ptrdiff_t>(view.chosen));
        changed = true;
    }
    view.chosen = std::min(view.chosen, layers.empty() ? 0 : layers.size() - 1);
    ImGui::SameLine();
    if (button("\u2191##Layer up", "Move the chosen layer up.", any && view.chosen > 0)) {
        move_layer(view, layers, view.chosen - 1);
        changed = true;
    }
    ImGui::SameLine();
    if (button("\u2193##Layer down", "Move the chosen layer down.", any && view.chosen + 1 < layers.size())) {
        move_layer(view, layers, view.chosen + 1);
        changed = true;
    }
    return changed;
}

}  // namespace

Distribution shown(const LayersView& view, const Distribution& distribution) {
    Distribution result = distribution;
    if (!view.solo || *view.solo >= result.layers.size() || !result.layers[*view.solo].enabled) return result;
    for (std::size_t i = 0; i < result.layers.size(); ++i) result.layers[i].enabled = i == *view.solo;
    if (result.layers[*view.solo].weight <= 0) result.layers[*view.solo].weight = 1;
    return result;
}

bool layers_panel(LayersView& view, Distribution& distribution) {
    Layers& layers = distribution.layers;
    view.chosen = std::min(view.chosen, layers.empty() ? 0 : layers.size() - 1);
    bool changed = layer_lines(view, layers);
    ImGui::Spacing();
    changed |= list_buttons(view, layers);
    // Also of what came or went elsewhere since the last frame.
    if (layers.size() != view.count) view.solo.reset();
    view.count = layers.size();
    ImGui::Spacing();
    if (!layers.empty()) {
        ImGui::PushID(static_cast<int>(view.chosen));
        changed |= layer_editor(layers[view.chosen], view.curve);
        ImGui::PopID();
    }
    return changed;
}

}  // namespace nacre::ui
