#include "core/model/facet_distribution.h"
#include "core/paint/lobe_handles.h"
#include "core/paint/painted_layer.h"
#include "ui/brush_surface.h"
#include "ui/canvas_paint.h"

namespace nacre::ui {
namespace {

// What a hand takes hold of at a normal: of a painted layer the highlight there, any other layer whole.
std::optional<CarriedLayer> taken(const Layer& layer, std::size_t index, const BrushSurface& surface) {
    CarriedLayer carried{index, layer, *surface.pointed_at, surface.surface, surface.pixel, {}};
    if (const auto* painted = std::get_if<PaintedLobe>(&layer.lobe)) {
        carried.highlight =
            Highlight::under(*paintable(*painted), glm::transpose(layer_frame(layer)) * carried.from);
        if (!carried.highlight) return {};
    }
    return carried;
}

// The layer with the most facets at a normal, if any has some there.
std::optional<std::size_t> strongest_layer(const FacetDistribution& p, dvec3 h) {
    std::optional<std::size_t> strongest;
    double most = 0;
    for (const PlacedLobe& placed : p.lobes()) {
        const double density = placed.scale * placed.lobe->density(glm::transpose(placed.frame) * h);
        if (density > most) most = density, strongest = placed.layer;
    }
    return strongest;
}

Layer dragged(const CarriedLayer& held, dvec3 to, const Layer& now) {
    if (!held.highlight) return carried(held.before, held.from, to);
    auto raster = held.highlight->carried(glm::transpose(layer_frame(held.before)) * to);
    if (!raster) return now;
    Layer layer = held.before;
    std::get<PaintedLobe>(layer.lobe).image = {{}, std::move(raster)};
    layer.source.reset();
    return layer;
}

// A press takes hold in the layer that is strongest there; a drag carries along what was taken.
bool grab_layers(CanvasState& state, const BrushSurface& surface, const FacetDistribution* seen,
                 Distribution& distribution, std::size_t& chosen) {
    if (state.carried && state.carried->surface == surface.surface &&
        (!surface.active || !ImGui::IsMouseDown(ImGuiMouseButton_Left)))
        state.carried.reset();
    const bool pointing = surface.hovered && surface.pointed_at;
    if (pointing && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
        const auto layer = seen != nullptr ? strongest_layer(*seen, *surface.pointed_at) : std::nullopt;
        if (layer && *layer < distribution.layers.size()) {
            chosen = *layer;
            state.carried = taken(distribution.layers[chosen], chosen, surface);
        }
    }
    if (!state.carried || state.carried->surface != surface.surface) return pointing;
    const auto to = surface.normal(surface.pixel);
    if (to && state.carried->layer < distribution.layers.size() && surface.pixel != state.carried->pixel) {
        state.carried->pixel = surface.pixel;
        Layer& layer = distribution.layers[state.carried->layer];
        layer = dragged(*state.carried, *to, layer);
    }
    return true;
}

}  // namespace

bool use_tool(CanvasState& state, const BrushSurface& surface, const FacetDistribution* seen,
              Distribution& distribution, std::size_t& chosen) {
    return state.tool == CanvasTool::grab ? grab_layers(state, surface, seen, distribution, chosen)
                                          : paint_layers(state, surface, seen, distribution, chosen);
}

}  // namespace nacre::ui
