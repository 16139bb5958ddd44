#include "ui/canvas_handles.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ui/canvas_path.h"
#include "ui/theme.h"

namespace nacre::ui {
namespace {

constexpr float reach = 9;    // pixels within which a press takes a handle
constexpr double apart = 11;  // at least, pixels from the axis, else an end cannot be told from it
constexpr int outline_steps = 240;

float scale() { return ImGui::GetFontSize() / 15; }

double distance(const CanvasFrame& frame, dvec3 h, glm::dvec2 pixel) {
    return frame.view.hidden(h) ? HUGE_VAL : glm::length(frame.view.pixel(h) - pixel);
}

bool is_enabled(const Layer& layer) { return layer.enabled; }

// The point of the outline nearest to a pixel.
std::optional<dvec3> outline_under(const CanvasFrame& frame, const Layer& layer, glm::dvec2 pixel) {
    if (!has_outline(layer)) return {};
    double nearest = static_cast<double>(reach * scale() * 0.8f);
    std::optional<dvec3> found;
    for (int i = 0; i < 2 * outline_steps; ++i) {
        const dvec3 h = outline_at(layer, i / (2.0 * outline_steps));
        if (const double d = distance(frame, h, pixel); d < nearest) nearest = d, found = h;
    }
    return found;
}

// A handle, and where it is drawn: an end keeps its distance from the axis, however narrow the lobe is.
struct ShownHandle {
    Handle handle;
    glm::dvec2 pixel;
    bool moved_apart = false;
};

std::vector<ShownHandle> shown_handles(const CanvasFrame& frame, const Layer& layer) {
    std::vector<ShownHandle> shown;
    const double least = apart * static_cast<double>(scale());
    for (const Handle& handle : handles_of(layer)) {
        ShownHandle place{handle, frame.view.pixel(handle.at)};
        if (frame.view.hidden(handle.at)) continue;
        if (!shown.empty()) {
            const glm::dvec2 off = place.pixel - shown.front().pixel;
            const double length = glm::length(off);
            place.moved_apart = length < least;
            if (place.moved_apart)
                place.pixel = shown.front().pixel + off * (length > 0 ? least / length : 0);
        } else if (handle.kind != HandleKind::axis) {
            continue;  // the axis itself is hidden
        }
        shown.push_back(place);
    }
    return shown;
}

std::optional<ShownHandle> chosen_handle(const CanvasFrame& frame, const Layer& layer, glm::dvec2 pixel) {
    double nearest = static_cast<double>(reach * scale());
    std::optional<ShownHandle> found;
    for (const ShownHandle& shown : shown_handles(frame, layer))
        if (const double d = glm::length(shown.pixel - pixel); d <= nearest) nearest = d, found = shown;
    if (found) return found;
    if (const auto h = outline_under(frame, layer, pixel))
        return ShownHandle{{HandleKind::outline, *h}, frame.view.pixel(*h)};
    return {};
}

void knob(ImVec2 at, float radius, const Colour& fill) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddCircleFilled(at, (radius + 1.5f) * scale(), IM_COL32(0, 0, 0, 170));
    list.AddCircleFilled(at, radius * scale(), ImGui::GetColorU32(fill));
}

bool same(const std::optional<GrabbedHandle>& handle, HandleKind kind, dvec3 at) {
    return handle && handle->kind == kind && glm::length(handle->at - at) < 1e-6;
}

void draw_chosen(const CanvasFrame& frame, const Layer& layer, const std::optional<GrabbedHandle>& hot) {
    const bool lit = hot && hot->kind == HandleKind::outline;
    if (has_outline(layer)) {
        const auto at = [&](double t) { return outline_at(layer, t); };
        draw_path(frame, at, outline_steps, IM_COL32(0, 0, 0, 130), (lit ? 5.0f : 3.6f) * scale());
        draw_path(frame, at, outline_steps, ImGui::GetColorU32(lit ? palette::accent_bright : palette::text),
                  (lit ? 2.4f : 1.5f) * scale());
    }
    for (const auto& [handle, pixel, moved] : shown_handles(frame, layer)) {
        const bool under = same(hot, handle.kind, handle.at);
        const float size = handle.kind == HandleKind::axis ? 5.5f : 4.5f;
        const float radius = size + (under ? 1.5f : 0.0f);
        const ImVec2 at(frame.low.x + static_cast<float>(pixel.x), frame.low.y + static_cast<float>(pixel.y));
        knob(at, radius, under ? palette::accent_bright : palette::text);
    }
}

// The handle keeps its distance from the pointer, so that it does not jump when it is taken.
Layer dragged(const CanvasFrame& frame, const GrabbedHandle& held, glm::dvec2 pixel) {
    const bool alone = ImGui::GetIO().KeyShift;
    if (held.moved_apart) {
        const glm::dvec2 axis = frame.view.pixel(handles_of(held.before).front().at);
        const glm::dvec2 now = *held.moved_apart + pixel - held.pixel;
        return widened(held.before, held.kind,
                       glm::length(now - axis) / glm::length(*held.moved_apart - axis), alone);
    }
    const dvec3 to = frame.view.nearest_direction(frame.view.pixel(held.at) + pixel - held.pixel);
    return pulled(held.before, held.kind, held.at, to, alone);
}

}  // namespace

std::optional<GrabbedHandle> handle_under(const CanvasFrame& frame, const Distribution& distribution,
                                          std::size_t chosen) {
    const auto& layers = distribution.layers;
    const glm::dvec2 pixel = frame.pixel(ImGui::GetIO().MousePos);
    if (chosen < layers.size() && is_enabled(layers[chosen]))
        if (const auto handle = chosen_handle(frame, layers[chosen], pixel))
            return GrabbedHandle{
                handle->handle.kind, chosen,
                handle->handle.at,   pixel,
                layers[chosen],      handle->moved_apart ? std::optional(handle->pixel) : std::nullopt};
    for (std::size_t i = 0; i < layers.size(); ++i) {
        const dvec3 axis = handles_of(layers[i]).front().at;
        if (is_enabled(layers[i]) && distance(frame, axis, pixel) <= static_cast<double>(reach * scale()))
            return GrabbedHandle{HandleKind::axis, i, axis, pixel, layers[i], {}};
    }
    return {};
}

bool handle_layers(CanvasState& state, const CanvasFrame& frame, Distribution& distribution,
                   std::size_t& chosen) {
    const bool hovered = ImGui::IsItemHovered();
    if (!ImGui::IsItemActive() || !ImGui::IsMouseDown(ImGuiMouseButton_Left)) state.grabbed.reset();
    if (hovered && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
        state.grabbed = handle_under(frame, distribution, chosen);
        if (state.grabbed) chosen = state.grabbed->layer;
        if (state.grabbed && state.grabbed->kind == HandleKind::axis &&
            ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
            distribution.layers[chosen].tilt = distribution.layers[chosen].azimuth = 0;
            state.grabbed.reset();
            return true;
        }
    }
    if (!state.grabbed || state.grabbed->layer >= distribution.layers.size())
        return hovered && handle_under(frame, distribution, chosen).has_value();
    const GrabbedHandle& held = *state.grabbed;
    const glm::dvec2 pixel = frame.pixel(ImGui::GetIO().MousePos);
    if (!ImGui::IsMouseDragging(ImGuiMouseButton_Left, 1)) return true;
    distribution.layers[held.layer] = dragged(frame, held, pixel);
    return true;
}

void draw_handles(const CanvasState& state, const CanvasFrame& frame, const Distribution& distribution,
                  std::size_t chosen) {
    std::optional<GrabbedHandle> hot = state.grabbed;
    if (!hot && frame.hovered) hot = handle_under(frame, distribution, chosen);
    const auto& layers = distribution.layers;
    for (std::size_t i = 0; i < layers.size(); ++i) {
        const dvec3 axis = handles_of(layers[i]).front().at;
        if (i == chosen || !is_enabled(layers[i]) || frame.view.hidden(axis)) continue;
        const bool under = hot && hot->layer == i;
        knob(frame.screen(axis), under ? 5.0f : 3.5f, under ? palette::accent_bright : palette::text_dim);
    }
    if (chosen < layers.size() && is_enabled(layers[chosen])) {
        // What is held has moved since it was taken.
        if (state.grabbed && hot->kind != HandleKind::outline)
            for (const Handle& handle : handles_of(layers[chosen]))
                if (handle.kind == hot->kind &&
                    distance(frame, handle.at, frame.pixel(ImGui::GetIO().MousePos)) <
                        distance(frame, hot->at, frame.pixel(ImGui::GetIO().MousePos)))
                    hot->at = handle.at;
        draw_chosen(frame, layers[chosen], hot && hot->layer == chosen ? hot : std::nullopt);
    }
}

std::string handle_text(const CanvasState& state, const Distribution& distribution) {
    if (!state.grabbed || state.grabbed->layer >= distribution.layers.size()) return {};
    const Layer& layer = distribution.layers[state.grabbed->layer];
    if (state.grabbed->kind == HandleKind::axis)
        return fmt::format("tilt {:.1f}\u00b0   azimuth {:.1f}\u00b0", layer.tilt, layer.azimuth);
    if (state.grabbed->kind == HandleKind::outline && outline_turns(layer))
        return fmt::format("rotation {:.1f}\u00b0", layer.rotation);
    const auto width = [](double value) {
        return std::isinf(value) ? "\u221e" : fmt::format("{:.3g}", value);
    };
    return std::visit(
        [&]<class T>(const T& lobe) -> std::string {
            constexpr WidthMembers<T> widths = T::width_members;
            if constexpr (widths.x == nullptr)
                return {};
            else if constexpr (widths.x == widths.y)
                return "width " + width(lobe.*widths.x);
            else
                return fmt::format("width {} \u00d7 {}", width(lobe.*widths.x), width(lobe.*widths.y));
        },
        layer.lobe);
}

}  // namespace nacre::ui
