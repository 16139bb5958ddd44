#include "ui/canvas_paint.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

#include "core/model/facet_distribution.h"
#include "core/paint/painted_layer.h"
#include "ui/canvas_path.h"
#include "ui/canvas_tools.h"
#include "ui/theme.h"

namespace nacre::ui {
namespace {

constexpr double radians = std::numbers::pi / 180;
constexpr double pixels_a_step = 2;  // of the way on the screen, so that a quick stroke stays as straight
constexpr double first_share = 0.5;  // weight of a blank layer's first paint, of the other layers'
constexpr int footprint_steps = 64;

bool is_painted(const Distribution& distribution, std::size_t index) {
    return index < distribution.layers.size() &&
           std::holds_alternative<PaintedLobe>(distribution.layers[index].lobe);
}

dvec3 in_layer(const Layer& layer, dvec3 h) { return glm::transpose(layer_frame(layer)) * h; }

void begin_stroke(CanvasState& state, PaintTool tool, const BrushSurface& surface, Distribution& distribution,
                  std::size_t& chosen) {
    if (!is_painted(distribution, chosen)) add_painted_layer(distribution, chosen);
    if (!is_painted(distribution, chosen)) return;
    Layer& layer = distribution.layers[chosen];
    auto& lobe = std::get<PaintedLobe>(layer.lobe);
    lobe.image = {{}, paintable(lobe)};
    const Raster& raster = *lobe.image.raster;
    const double mass = raster_mass(raster);
    if (mass > 0) layer.enabled = true;
    make_room_for_paint(distribution, chosen, mass);
    const double others = weight_of_others(distribution, chosen);
    StrokeStyle style{
        .tool = tool, .brush = state.brush, .symmetry = state.symmetry, .tip = {}, .rays = state.rays};
    if (state.stamp < state.stamps.size()) style.tip = state.stamps[state.stamp].picture;
    state.held = HeldBrush{.layer = chosen,
                           .before = layer,
                           .mass = mass,
                           .first_weight = others > 0 ? first_share * others : 1,
                           .stroke = {raster, std::move(style), in_layer(layer, *surface.pointed_at)},
                           .pixel = surface.pixel,
                           .surface = surface.surface};
}

std::shared_ptr<const Raster> continued(const BrushSurface& surface, HeldBrush& held) {
    const glm::dvec2 way = surface.pixel - held.pixel;
    const int steps = std::max(1, static_cast<int>(std::ceil(glm::length(way) / pixels_a_step)));
    if (way != glm::dvec2(0))
        for (int i = 1; i <= steps; ++i)
            if (const auto h = surface.normal(held.pixel + way * (static_cast<double>(i) / steps)))
                held.stroke.move_to(in_layer(held.before, *h));
    return held.stroke.raster();
}

// The edge of what a dab covers, about `middle` in the layer's frame.
dvec3 round_edge(dvec3 middle, double angle, double t) {
    const double psi = 2 * std::numbers::pi * t;
    return shortest_rotation({0, 0, 1}, middle) *
           dvec3(std::sin(angle) * std::cos(psi), std::sin(angle) * std::sin(psi), std::cos(angle));
}

// The edge of what a stamp covers: `half` the angle from its middle to a side of its square.
dvec3 stamp_edge(dvec3 middle, double half, glm::dvec2 reach, double t) {
    const double side = std::min(std::floor(4 * t), 3.0), along = 2 * (4 * t - side) - 1;
    const dvec2 corner = side < 1   ? dvec2(along, 1)
                         : side < 2 ? dvec2(1, -along)
                         : side < 3 ? dvec2(-along, -1)
                                    : dvec2(-1, along);
    const dvec2 at = corner * reach;
    const double angle = half * glm::length(at), sine = std::sin(angle) / glm::length(at);
    return shortest_rotation({0, 0, 1}, middle) * dvec3(at * sine, std::cos(angle));
}

void outline(const CanvasFrame& frame, const std::function<dvec3(double)>& at, bool strong) {
    const float scale = ImGui::GetFontSize() / 15;
    if (strong) draw_path(frame, at, footprint_steps, IM_COL32(0, 0, 0, 150), 3.2f * scale);
    const Colour colour{1, 1, 1, strong ? 0.95f : 0.4f};
    draw_path(frame, at, footprint_steps, ImGui::GetColorU32(colour), (strong ? 1.4f : 1.0f) * scale);
}

// A full ring covers all normals between two polar angles.
void draw_ring(const CanvasFrame& frame, const glm::dmat3& place, double theta, double radius) {
    for (const double edge : {theta - radius, theta + radius}) {
        if (edge <= 0 || edge >= 0.5 * std::numbers::pi) continue;
        outline(
            frame,
            [&](double t) {
                return place * round_edge({0, 0, 1}, edge, t);
            },
            true);
    }
}

}  // namespace

void add_painted_layer(Distribution& distribution, std::size_t& chosen) {
    auto& layers = distribution.layers;
    if (layers.size() >= limits::layers_max) return;
    const std::size_t at = std::min(chosen + 1, layers.size());
    layers.insert(layers.begin() + static_cast<std::ptrdiff_t>(at), blank_painted_layer());
    chosen = at;
}

bool paint_layers(CanvasState& state, const BrushSurface& surface, Distribution& distribution,
                  std::size_t& chosen) {
    if (state.held && state.held->surface == surface.surface &&
        (!surface.active || !ImGui::IsMouseDown(ImGuiMouseButton_Left)))
        state.held.reset();
    const bool pointing = surface.hovered && surface.pointed_at;
    const auto tool = paints_with(state.tool);
    if (pointing && tool && ImGui::IsMouseClicked(ImGuiMouseButton_Left))
        begin_stroke(state, *tool, surface, distribution, chosen);
    if (!state.held || state.held->surface != surface.surface) return pointing;
    if (!is_painted(distribution, state.held->layer)) {
        state.held.reset();
        return true;
    }
    auto raster = continued(surface, *state.held);
    state.held->pixel = surface.pixel;
    Layer& layer = distribution.layers[state.held->layer];
    if (std::get<PaintedLobe>(layer.lobe).image.raster == raster) return true;
    layer = state.held->before;
    set_raster(layer, std::move(raster), state.held->mass, state.held->first_weight);
    return true;
}

void draw_brush(const CanvasState& state, const CanvasFrame& frame, const CanvasContents& contents) {
    const std::optional<dvec3>& at = frame.cursor ? frame.cursor : contents.marked;
    const auto tool = paints_with(state.tool);
    if (!at || !tool) return;
    const PaintToolInfo& kind = info(*tool);
    const auto* dabs = std::get_if<DabTool>(&kind.work);
    const Distribution& design = *contents.design;
    const glm::dmat3 place =
        is_painted(design, contents.chosen) ? layer_frame(design.layers[contents.chosen]) : glm::dmat3(1);
    const dvec3 middle = glm::transpose(place) * *at;
    const double radius = state.brush.radius * radians;
    if (middle.z < -0.5) return;
    if (state.symmetry.kind == SymmetryKind::ring && dabs != nullptr && dabs->follows_way)
        draw_ring(frame, place, angle_between({0, 0, 1}, middle), radius);
    const auto images = symmetry_images(state.symmetry);
    for (std::size_t i = images.size(); i-- > 0;) {
        const glm::dmat3 to = place * images[i];
        const bool first = i == 0;
        if (kind.needs == ToolNeed::picture && state.stamp < state.stamps.size()) {
            const glm::dvec2 reach = state.stamps[state.stamp].reach;
            outline(
                frame, [&](double t) { return to * stamp_edge(middle, radius, reach, t); }, first);
            continue;
        }
        outline(
            frame, [&](double t) { return to * round_edge(middle, radius, t); }, first);
        if (first && state.brush.hardness > 0.05 && state.brush.hardness < 0.95)
            outline(
                frame, [&](double t) { return to * round_edge(middle, radius * state.brush.hardness, t); },
                false);
    }
}

}  // namespace nacre::ui
