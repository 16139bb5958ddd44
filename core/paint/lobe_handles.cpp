#include "core/paint/lobe_handles.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/model/facet_distribution.h"
#include "core/paint/brush.h"

namespace nacre {
namespace {

constexpr double degrees = 180 / std::numbers::pi;
constexpr double width_min = 1e-3;  // a hand can do no better on a picture of some hundred pixels
constexpr double slope_max = 60;    // tan 89.05 degrees: from here on a width is infinite

// The widths of a lobe as slopes; equal pointers for a lobe with one.
struct Widths {
    double* x = nullptr;
    double* y = nullptr;
    bool inverted = false;  // the width is the slope's inverse, as of an inverse Gaussian
    bool may_be_infinite = false;
};

template <class T>
bool may_be_infinite(double T::*member) {
    bool found = false;
    visit_parameters<T>([&]<class Parameter>(const Parameter& parameter) {
        if constexpr (std::is_same_v<Parameter, NumberParameter<T>>)
            found = found || (parameter.member == member && parameter.may_be_infinite);
    });
    return found;
}

Widths width_pointers(Lobe& lobe) {
    return std::visit(
        []<class T>(T& kind) -> Widths {
            constexpr WidthMembers<T> widths = T::width_members;
            if constexpr (widths.x == nullptr)
                return {};
            else
                return {&(kind.*widths.x), &(kind.*widths.y), widths.inverse, may_be_infinite(widths.x)};
        },
        lobe);
}

double slope(double width, bool inverted) {
    if (std::isinf(width)) return inverted ? 0 : slope_max;
    return inverted ? 1 / width : width;
}

dvec2 slopes_of(const Lobe& lobe) {
    Lobe copy = lobe;
    const Widths widths = width_pointers(copy);
    return {slope(*widths.x, widths.inverted), slope(*widths.y, widths.inverted)};
}

bool has_widths(const Lobe& lobe) {
    Lobe copy = lobe;
    return width_pointers(copy).x != nullptr;
}

bool is_inverted(const Lobe& lobe) {
    Lobe copy = lobe;
    return width_pointers(copy).inverted;
}

bool is_round(const Lobe& lobe) {
    if (!has_widths(lobe)) return true;
    const dvec2 s = slopes_of(lobe);
    return s.x == s.y;
}

double width_of(double new_slope, const Widths& widths) {
    new_slope = std::clamp(new_slope, width_min, slope_max);
    if (widths.inverted) return 1 / new_slope;
    return widths.may_be_infinite && new_slope >= slope_max ? limits::infinity : new_slope;
}

dvec3 local(const Layer& layer, dvec3 h) { return glm::transpose(layer_frame(layer)) * h; }

double slope_along(double across, double up) { return up > 0 ? std::abs(across) / up : slope_max; }

void tilt_axis(Layer& layer, dvec3 to) {
    layer.tilt = std::atan2(std::hypot(to.x, to.y), to.z) * degrees;
    if (to.x != 0 || to.y != 0) layer.azimuth = std::atan2(to.y, to.x) * degrees;
}

void turn(Layer& layer, dvec3 from, dvec3 to) {
    const dvec3 a = local(layer, from), b = local(layer, to);
    const double by = (std::atan2(b.y, b.x) - std::atan2(a.y, a.x)) * degrees;
    layer.rotation = std::remainder(layer.rotation + by, 360.0);
}

void widen(Layer& layer, dvec3 from, dvec3 to) {
    const dvec3 a = local(layer, from), b = local(layer, to);
    const double before = slope_along(std::hypot(a.x, a.y), a.z);
    const double factor = slope_along(std::hypot(b.x, b.y), b.z) / std::max(before, width_min);
    const Widths widths = width_pointers(layer.lobe);
    const double now = slopes_of(layer.lobe).x * factor;
    *widths.x = *widths.y = width_of(now, widths);
}

}  // namespace

Layer carried(const Layer& layer, dvec3 from, dvec3 to) {
    if (glm::dot(from, to) < -0.999) return layer;
    const glm::dmat3 frame = shortest_rotation(from, to) * layer_frame(layer);
    Layer result = layer;
    tilt_axis(result, frame[2]);
    // layer_frame() with no rotation, undone: what is left turns about the axis.
    result.rotation = 0;
    const glm::dmat3 left = glm::transpose(layer_frame(result)) * frame;
    result.rotation = std::atan2(left[0].y, left[0].x) * degrees;
    return result;
}

void straighten(Distribution& distribution, dvec3 mean) {
    for (Layer& layer : distribution.layers) layer = carried(layer, glm::normalize(mean), {0, 0, 1});
}

bool has_outline(const Layer& layer) { return has_widths(layer.lobe) || holds_picture(layer.lobe); }

bool outline_turns(const Layer& layer) {
    return !is_round(layer.lobe) || layer.modulation || holds_picture(layer.lobe);
}

dvec3 outline_at(const Layer& layer, double t) {
    const double psi = 2 * std::numbers::pi * t;
    dvec3 h{std::cos(psi), std::sin(psi), 0};
    if (has_widths(layer.lobe)) {
        // Of a long outline more points lie where it bends.
        const dvec2 s = slopes_of(layer.lobe);
        const dvec2 even = glm::normalize(dvec2(h.x * std::sqrt(s.y), h.y * std::sqrt(s.x)));
        h = {even.x * s.x, even.y * s.y, 1};
    }
    return layer_frame(layer) * glm::normalize(h);
}

std::vector<Handle> handles_of(const Layer& layer) {
    std::vector<Handle> handles{{HandleKind::axis, layer_frame(layer)[2]}};
    if (!has_widths(layer.lobe) || is_inverted(layer.lobe)) return handles;
    for (const double t : {0.0, 0.5}) handles.push_back({HandleKind::width_x, outline_at(layer, t)});
    for (const double t : {0.25, 0.75}) handles.push_back({HandleKind::width_y, outline_at(layer, t)});
    return handles;
}

Layer widened(const Layer& layer, HandleKind end, double factor, bool alone) {
    Layer result = layer;
    const Widths widths = width_pointers(result.lobe);
    if (widths.x == nullptr) return result;
    const dvec2 s = slopes_of(layer.lobe) * factor;
    const bool x = end == HandleKind::width_x;
    double &own = x ? *widths.x : *widths.y, &other = x ? *widths.y : *widths.x;
    const bool was_infinite = std::isinf(own);
    own = width_of(x ? s.x : s.y, widths);
    const bool both = !alone && &other != &own && !was_infinite && !std::isinf(own) && !std::isinf(other);
    if (both) other = width_of(x ? s.y : s.x, widths);
    return result;
}

std::optional<LobeShape> shape_of(const Lobe& lobe) {
    if (!has_widths(lobe) || is_inverted(lobe)) return {};
    Lobe copy = lobe;
    const Widths widths = width_pointers(copy);
    if (std::isinf(*widths.x) || std::isinf(*widths.y)) return {};
    const dvec2 s = slopes_of(lobe);
    return LobeShape{std::sqrt(s.x * s.y), s.x / s.y};
}

void set_shape(Lobe& lobe, const LobeShape& shape) {
    if (!shape_of(lobe)) return;
    const Widths widths = width_pointers(lobe);
    const double root = widths.x == widths.y ? 1 : std::sqrt(shape.stretch);
    *widths.x = std::clamp(shape.softness * root, limits::width_min, limits::width_max);
    if (widths.y != widths.x)
        *widths.y = std::clamp(shape.softness / root, limits::width_min, limits::width_max);
}

Layer pulled(const Layer& layer, HandleKind kind, dvec3 from, dvec3 to, bool alone) {
    Layer result = layer;
    if (kind == HandleKind::axis) {
        tilt_axis(result, to);
    } else if (kind == HandleKind::outline) {
        if (outline_turns(layer))
            turn(result, from, to);
        else if (has_widths(layer.lobe))
            widen(result, from, to);
    } else {
        if (!has_widths(layer.lobe)) return result;
        const bool x = kind == HandleKind::width_x;
        const dvec3 l = local(layer, to);
        const dvec2 s = slopes_of(layer.lobe);
        return widened(layer, kind, slope_along(x ? l.x : l.y, l.z) / (x ? s.x : s.y), alone);
    }
    return result;
}

}  // namespace nacre
