#include "ui/brush_mark.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/paint/layer_paint.h"
#include "core/paint/painted_layer.h"
#include "core/paint/tip.h"
#include "ui/canvas_path.h"
#include "ui/canvas_tools.h"
#include "ui/stamp_picture.h"
#include "ui/theme.h"

namespace nacre::ui {
namespace {

constexpr double radians = std::numbers::pi / 180;
constexpr int footprint_steps = 64;
constexpr double line_width = 0.4 * radians;  // of the brush's edge on the object
constexpr double deepest = -0.5;              // z in the layer's frame: a brush farther below is not shown
constexpr Colour ghost{1, 1, 1, 0.6f};
constexpr Colour ghost_of_copy{1, 1, 1, 0.25f};

// The layer that the next stroke will paint on.
Layer painted_or_new(const CanvasState& state, const Distribution& distribution, std::size_t chosen) {
    const auto& layers = distribution.layers;
    const bool painted =
        chosen < layers.size() && has_part(layers[chosen], part_in_hand(state, distribution, chosen));
    return painted ? layers[chosen] : Layer{};
}

const NamedStamp* stamp_in_hand(const CanvasState& state) {
    const auto tool = paints_with(state.tool);
    if (!tool || info(*tool).needs != ToolNeed::picture || state.stamp >= state.stamps.size()) return nullptr;
    return &state.stamps[state.stamp];
}

// What the stamp would do at a normal of the layer's frame.
Tip tip_of(const NamedStamp& stamp, const CanvasState& state, const Layer& layer, dvec3 at) {
    return Tip({.brush = state.brush,
                .symmetry = {},
                .at = at,
                .tip = stamp.picture.get(),
                .to_tip = stamp_from_layer(layer, at, state.pose)});
}

// The edge of what a dab covers, about `middle` in the layer's frame.
dvec3 round_edge(dvec3 middle, double angle, double t) {
    const double psi = 2 * std::numbers::pi * t;
    return shortest_rotation({0, 0, 1}, middle) *
           dvec3(std::sin(angle) * std::cos(psi), std::sin(angle) * std::sin(psi), std::cos(angle));
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

// `to` takes the layer's frame to the surface's.
void draw_ghost(const CanvasFrame& frame, const glm::dmat3& to, const Tip& tip, const Raster& thumbnail,
                bool strong) {
    const auto place = [&](glm::dvec2 at) -> std::optional<ImVec2> {
        const dvec3 h = to * tip.direction(at);
        return frame.view.hidden(h) ? std::nullopt : std::optional(frame.screen(h));
    };
    draw_stamp(thumbnail, place, strong ? ghost : ghost_of_copy);
}

// Where a tool without a width points, and the way that it is drawn out along.
void draw_point(const CanvasFrame& frame, dvec3 at, bool strong) {
    if (frame.view.hidden(at)) return;
    const ImVec2 middle = frame.screen(at);
    const float scale = ImGui::GetFontSize() / 15;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddCircle(middle, 4 * scale, IM_COL32(0, 0, 0, 150), 0, 3.2f * scale);
    list.AddCircle(middle, 4 * scale, ImGui::GetColorU32(Colour{1, 1, 1, strong ? 0.95f : 0.4f}), 0,
                   1.4f * scale);
}

void draw_way(const CanvasFrame& frame, const HeldBrush& held) {
    const dvec3 from = held.begin, to = held.end;
    const auto at = [&](double t) { return glm::normalize(from + (to - from) * t); };
    const float scale = ImGui::GetFontSize() / 15;
    draw_path(frame, at, footprint_steps, IM_COL32(0, 0, 0, 150), 3.2f * scale);
    draw_path(frame, at, footprint_steps, ImGui::GetColorU32(Colour{1, 1, 1, 0.95f}), 1.4f * scale);
    draw_point(frame, from, true);
}

}  // namespace

void draw_brush(const CanvasState& state, const CanvasFrame& frame, const CanvasContents& contents) {
    const std::optional<dvec3>& at = frame.cursor ? frame.cursor : contents.marked;
    const auto tool = paints_with(state.tool);
    if (!at || !tool) return;
    const PaintToolInfo& kind = info(*tool);
    const auto* dabs = std::get_if<DabTool>(&kind.work);
    const Layer layer = painted_or_new(state, *contents.design, contents.chosen);
    const glm::dmat3 place = layer_frame(layer);
    const dvec3 pointed = glm::transpose(place) * *at;
    if (pointed.z < deepest) return;
    const dvec3 middle = above_horizon(pointed);
    const bool wide = is_as_wide_as_brush(kind);
    if (!wide && state.held) draw_way(frame, *state.held);
    const double radius = state.brush.radius * radians;
    if (state.symmetry.kind == SymmetryKind::ring && dabs != nullptr && dabs->follows_way)
        draw_ring(frame, place, angle_between({0, 0, 1}, middle), radius);
    const auto images = symmetry_images(state.symmetry);
    const NamedStamp* const stamp = stamp_in_hand(state);
    for (std::size_t i = images.size(); i-- > 0;) {
        const glm::dmat3 to = place * images[i];
        const bool first = i == 0;
        if (stamp) {
            draw_ghost(frame, to, tip_of(*stamp, state, layer, middle), *stamp->thumbnail, first);
            continue;
        }
        if (!wide) {
            draw_point(frame, to * middle, first);
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

std::function<double(dvec3 h)> brush_veil(const CanvasState& state, const Distribution& distribution,
                                          std::size_t chosen, dvec3 at) {
    const auto tool = paints_with(state.tool);
    if (!tool || !is_as_wide_as_brush(info(*tool))) return {};
    const Layer layer = painted_or_new(state, distribution, chosen);
    const glm::dmat3 place = layer_frame(layer);
    if (const NamedStamp* const stamp = stamp_in_hand(state)) {
        const dvec3 middle = above_horizon(glm::transpose(place) * at);
        return [place, tip = tip_of(*stamp, state, layer, middle)](dvec3 h) { return tip(h * place); };
    }
    const double radius = state.brush.radius * radians;
    const double outermost = std::cos(std::min(radius + 4 * line_width, std::numbers::pi));
    return [at, radius, outermost](dvec3 h) {
        if (glm::dot(h, at) < outermost) return 0.0;
        const double off = (angle_between(h, at) - radius) / line_width;
        return std::exp(-off * off);
    };
}

}  // namespace nacre::ui
