#include "ui/canvas_paint.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/model/facet_distribution.h"
#include "core/paint/density_picture.h"
#include "core/paint/painted_layer.h"
#include "core/paint/raster_texels.h"
#include "ui/canvas_tools.h"

namespace nacre::ui {
namespace {

constexpr double pixels_a_step = 2;    // of the way on the screen, so that a quick stroke stays as straight
constexpr double pixels_a_fold = 110;  // of a drag with Shift that makes the brush e times larger
constexpr double click_pixels = 3;     // a shorter drag is a click
constexpr double usual_pace = 700;     // pixels a second
constexpr double pace_kept = 0.6;  // from one frame to the next, so that the hand's trembling does not show

dvec3 in_layer(const Layer& layer, dvec3 h) { return glm::transpose(layer_frame(layer)) * h; }

std::shared_ptr<const TexelShares> selected_texels(const CanvasState& state, const LayerPaint& paint) {
    if (!state.selection) return nullptr;
    return state.selection->texels(layer_frame(paint.before()), paint.raster()->width);
}

// `from` is a normal in the surface's frame.
void begin_stroke(CanvasState& state, PaintTool tool, const BrushSurface& surface, dvec3 from,
                  Distribution& distribution, std::size_t& chosen) {
    // A press beside what is selected covers nothing: no layer begins for it.
    const bool is_area = std::holds_alternative<AreaTool>(info(tool).work);
    if (is_area && state.selection && !((*state.selection)(from) > 0)) return;
    std::optional<Distribution> origin;
    if (std::holds_alternative<GradientTool>(info(tool).work)) origin = distribution;
    const std::size_t chosen_before = chosen;
    auto paint = LayerPaint::open(distribution, chosen, part_in_hand(state, distribution, chosen));
    if (!paint) return;
    StrokeStyle style{.tool = tool,
                      .brush = state.brush,
                      .symmetry = state.symmetry,
                      .tip = {},
                      .rays = state.rays,
                      .form = state.form,
                      .tolerance = state.tolerance,
                      .selected = selected_texels(state, *paint)};
    const dvec3 at = in_layer(paint->before(), from);
    if (state.stamp < state.stamps.size()) {
        style.tip = state.stamps[state.stamp].picture;
        style.to_tip = stamp_from_layer(paint->before(), above_horizon(at), state.pose);
    }
    const Raster& raster = *paint->raster();
    state.held = HeldBrush{.paint = *std::move(paint),
                           .stroke = {raster, std::move(style), at, {.pressure = state.pressure.value_or(1)}},
                           .pixel = surface.pixel,
                           .begin = from,
                           .end = from,
                           .surface = surface.surface,
                           .touch = {.pressure = state.pressure.value_or(1)},
                           .origin = std::move(origin),
                           .chosen = chosen_before};
}

void go_to(HeldBrush& held, dvec3 h, const Touch& touch = {}) {
    held.stroke.move_to(in_layer(held.paint.before(), h), touch);
    held.end = h;
}

// The hand after it has gone so many pixels in this frame.
Touch touch_after(const CanvasState& state, const Touch& before, double pixels) {
    const double pace = pixels / std::max(static_cast<double>(ImGui::GetIO().DeltaTime), 1e-3);
    return {state.pressure.value_or(1), std::lerp(1 / (1 + pace / usual_pace), before.slowness, pace_kept)};
}

// The brush follows the pointer on a string of so many pixels.
void follow(const CanvasState& state, const BrushSurface& surface, HeldBrush& held, double string) {
    const glm::dvec2 from = held.pixel, off = surface.pixel - from;
    const double length = glm::length(off);
    const Touch before =
        std::exchange(held.touch, touch_after(state, held.touch, std::max(length - string, 0.0)));
    if (!(length > string)) return;
    const glm::dvec2 way = off * ((length - string) / length);
    const int steps = std::max(1, static_cast<int>(std::ceil(glm::length(way) / pixels_a_step)));
    for (int i = 1; i <= steps; ++i)
        if (const double part = static_cast<double>(i) / steps;
            const auto h = surface.normal(from + way * part))
            go_to(held, *h, between(before, held.touch, part));
    held.pixel = from + way;
}

void show_stroke(HeldBrush& held, Distribution& distribution) {
    auto raster = held.stroke.raster();
    Layer& layer = distribution.layers[held.paint.layer()];
    if (part_picture(layer, held.paint.part())->raster == raster) return;
    layer = held.paint.with(std::move(raster));
}

void end_stroke(CanvasState& state, Distribution& distribution, std::size_t& chosen) {
    if (state.held->origin && state.held->begin == state.held->end) {
        distribution = *std::move(state.held->origin);
        chosen = state.held->chosen;
        return state.held.reset();
    }
    state.last_stroke = StrokeEnd{state.held->paint.layer(), state.held->end};
    state.held.reset();
}

// From where the last stroke of this layer ended.
void draw_line(CanvasState& state, PaintTool tool, const BrushSurface& surface, Distribution& distribution,
               std::size_t& chosen) {
    const bool goes_on = state.last_stroke && state.last_stroke->layer == chosen;
    begin_stroke(state, tool, surface, goes_on ? state.last_stroke->at : *surface.pointed_at, distribution,
                 chosen);
    if (!state.held) return;
    go_to(*state.held, *surface.pointed_at);
    show_stroke(*state.held, distribution);
    end_stroke(state, distribution, chosen);
}

// Whether Escape has let go of what the button still holds: nothing more comes of it.
bool is_cancelled(const BrushSurface& surface) {
    return !surface.active && ImGui::IsMouseDown(ImGuiMouseButton_Left);
}

// Shift on the canvas. Returns whether the pointer is its.
bool size_brush(CanvasState& state, PaintTool tool, const BrushSurface& surface, Distribution& distribution,
                std::size_t& chosen) {
    if (state.sized && state.sized->surface != surface.surface) return false;
    if (!state.sized) {
        if (surface.surface != Surface::canvas || !ImGui::GetIO().KeyShift || !surface.pointed_at ||
            !surface.hovered || !ImGui::IsMouseClicked(ImGuiMouseButton_Left))
            return false;
        state.sized =
            SizedBrush{.pixel = surface.pixel, .radius = state.brush.radius, .surface = surface.surface};
    }
    if (is_cancelled(surface)) {
        state.brush.radius = state.sized->radius;
        state.sized.reset();
        return true;
    }
    const double way = surface.pixel.x - state.sized->pixel.x;
    state.sized->dragged = state.sized->dragged || std::abs(way) > click_pixels;
    if (state.sized->dragged)
        state.brush.radius = std::clamp(state.sized->radius * std::exp(way / pixels_a_fold), brush_radius_min,
                                        brush_radius_max);
    if (surface.active) return true;
    if (!state.sized->dragged && surface.pointed_at) draw_line(state, tool, surface, distribution, chosen);
    state.sized.reset();
    return true;
}

// Of the chosen layer's mask or of its paint, if it has any, else p over its peak.
double value_at(const Distribution& distribution, std::size_t chosen, LayerPart part,
                const FacetDistribution* seen, dvec3 h) {
    if (chosen < distribution.layers.size() && has_part(distribution.layers[chosen], part)) {
        const Layer& layer = distribution.layers[chosen];
        const Raster& raster = *part_raster(layer, part);
        return raster_value(raster.values, raster.width, disk_point(above_horizon(in_layer(layer, h))));
    }
    const double peak = seen != nullptr ? peak_density(*seen) : 0;
    return peak > 0 ? seen->density(h) / peak : 0;
}

bool picks() { return ImGui::GetIO().KeyCtrl || ImGui::GetIO().KeyAlt; }

}  // namespace

void paint_selection(const CanvasState& state, const Brush& brush, Distribution& distribution,
                     std::size_t& chosen) {
    if (!state.selection) return;
    const auto paint = LayerPaint::open(distribution, chosen, part_in_hand(state, distribution, chosen));
    if (!paint) return;
    distribution.layers[chosen] =
        paint->with(painted_over(*paint->raster(), *selected_texels(state, *paint), brush));
}

bool paint_layers(CanvasState& state, const BrushSurface& surface, const FacetDistribution* seen,
                  Distribution& distribution, std::size_t& chosen) {
    const auto tool = paints_with(state.tool);
    const bool has_size = tool && is_as_wide_as_brush(info(*tool));
    if (has_size && size_brush(state, *tool, surface, distribution, chosen)) return true;
    const bool pointing = surface.hovered && surface.pointed_at;
    if (pointing && tool && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
        if (picks())
            state.brush.value =
                std::clamp(value_at(distribution, chosen, part_in_hand(state, distribution, chosen), seen,
                                    *surface.pointed_at),
                           0.0, 1.0);
        else
            begin_stroke(state, *tool, surface, *surface.pointed_at, distribution, chosen);
    }
    if (!state.held || state.held->surface != surface.surface) return pointing;
    if (is_cancelled(surface) || !state.held->paint.stands_in(distribution)) {
        state.held.reset();
        return true;
    }
    const bool released = !surface.active;
    follow(state, surface, *state.held, released ? 0 : state.steadiness);
    show_stroke(*state.held, distribution);
    if (released) end_stroke(state, distribution, chosen);
    return true;
}

}  // namespace nacre::ui
