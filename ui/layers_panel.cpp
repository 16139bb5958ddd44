#include "ui/layers_panel.h"

#include <imgui.h>

#include <algorithm>
#include <string>
#include <utility>

#include "ui/item_map.h"
#include "ui/layer_list.h"
#include "ui/widgets.h"

namespace nacre::ui {
namespace {

using Layers = std::vector<Layer>;

bool add_button(LayersView& view, Layers& layers) {
    bool changed = false;
    const bool room = layers.size() < limits::layers_max;
    if (button("+ Add##Add layer", "Add a layer of any kind.", room)) ImGui::OpenPopup("kinds");
    if (!ImGui::BeginPopup("kinds")) return false;
    for (std::size_t kind = 0; kind < KindSet<Lobe>::count; ++kind) {
        const bool pressed = ImGui::MenuItem(KindSet<Lobe>::labels[kind]);
        note_item(std::string("Add ") + KindSet<Lobe>::labels[kind]);
        tooltip_for_item(KindSet<Lobe>::explanations[kind]);
        if (!pressed) continue;
        Layer layer;
        layer.lobe = lobe_of_widths(kind);
        layers.push_back(std::move(layer));
        view.chosen = layers.size() - 1;
        changed = true;
    }
    ImGui::EndPopup();
    return changed;
}

bool list_buttons(LayersView& view, Layers& layers) {
    bool changed = add_button(view, layers);
    const auto action_button = [&](const char* label, const char* text, LayerAction action) {
        stay_on_line(button_width(label), ImGui::GetStyle().ItemSpacing.x);
        if (button(label, text, possible(action, view.chosen, layers.size())))
            changed |= act(action, view, layers);
    };
    action_button("Duplicate##Duplicate layer", "A copy of the chosen layer, after it.",
                  LayerAction::duplicate);
    action_button("Delete##Delete layer", "Remove the chosen layer. A design needs at least one.",
                  LayerAction::remove);
    action_button("\u2191##Layer up", "Move the chosen layer up.", LayerAction::up);
    action_button("\u2193##Layer down", "Move the chosen layer down.", LayerAction::down);
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

bool layers_panel(LayersView& view, Distribution& distribution, bool& paints_mask) {
    Layers& layers = distribution.layers;
    view.chosen = std::min(view.chosen, layers.empty() ? 0 : layers.size() - 1);
    bool changed = layer_list(view, layers);
    ImGui::Spacing();
    changed |= list_buttons(view, layers);
    // Also of what came or went elsewhere since the last frame.
    if (layers.size() != view.count) view.solo.reset(), view.rename.reset();
    view.count = layers.size();
    ImGui::Spacing();
    if (!layers.empty()) {
        ImGui::PushID(static_cast<int>(view.chosen));
        changed |= layer_editor(layers[view.chosen], view, paints_mask);
        ImGui::PopID();
    }
    return changed;
}

}  // namespace nacre::ui
