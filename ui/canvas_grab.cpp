#include "core/paint/lobe_handles.h"
#include "ui/brush_surface.h"
#include "ui/canvas_paint.h"

namespace nacre::ui {
namespace {

// A press takes the layer that is strongest there; a drag carries it along, rigidly.
bool grab_layers(CanvasState& state, const BrushSurface& surface, Distribution& distribution,
                 std::size_t& chosen) {
    if (state.carried && state.carried->surface == surface.surface &&
        (!surface.active || !ImGui::IsMouseDown(ImGuiMouseButton_Left)))
        state.carried.reset();
    const bool pointing = surface.hovered && surface.pointed_at;
    if (pointing && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
        const auto layer = state.strongest_layer ? state.strongest_layer(*surface.pointed_at) : std::nullopt;
        if (layer && *layer < distribution.layers.size()) {
            chosen = *layer;
            state.carried =
                CarriedLayer{chosen, distribution.layers[chosen], *surface.pointed_at, surface.surface};
        }
    }
    if (!state.carried || state.carried->surface != surface.surface) return pointing;
    const auto to = surface.normal(surface.pixel);
    if (to && state.carried->layer < distribution.layers.size() &&
        ImGui::IsMouseDragging(ImGuiMouseButton_Left, 1))
        distribution.layers[state.carried->layer] = carried(state.carried->before, state.carried->from, *to);
    return true;
}

}  // namespace

bool use_tool(CanvasState& state, const BrushSurface& surface, Distribution& distribution,
              std::size_t& chosen) {
    return state.tool == CanvasTool::grab ? grab_layers(state, surface, distribution, chosen)
                                          : paint_layers(state, surface, distribution, chosen);
}

}  // namespace nacre::ui
