#include "ui/canvas_transform.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <utility>

#include "ui/canvas_tools.h"
#include "ui/escape.h"
#include "ui/keys.h"
#include "ui/theme.h"
#include "ui/toolbar_fields.h"
#include "ui/widgets.h"

namespace nacre::ui {
namespace {

constexpr double reach = 9;       // pixels within which a press takes a handle
constexpr double knob_away = 24;  // pixels of the knob that turns from the box
constexpr double turn_step = 15;  // degrees
constexpr int side_steps = 16;    // of a side's line, which the dome bends

constexpr std::array<dvec2, 8> handles{
    {{-1, -1}, {0, -1}, {1, -1}, {1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}}};

double scale() { return static_cast<double>(ImGui::GetFontSize()) / 15; }

// Above the side that is seen on top.
glm::dvec2 knob_pixel(const CanvasFrame& frame, const DiskBox& box) {
    const glm::dvec2 middle = frame.view.disk_pixel(box.middle);
    glm::dvec2 top(0, HUGE_VAL);
    for (const dvec2 side : {dvec2(1, 0), {-1, 0}, {0, 1}, {0, -1}})
        if (const glm::dvec2 at = frame.view.disk_pixel(box.at(side)); at.y < top.y) top = at;
    const double away = glm::length(top - middle);
    return top + (away > 0 ? (top - middle) / away : glm::dvec2(0, -1)) * (knob_away * scale());
}

std::optional<TransformGrip> grip_under(const CanvasFrame& frame, const DiskBox& box, glm::dvec2 pixel) {
    const dvec2 at = frame.view.disk_under(pixel);
    const auto near = [&](glm::dvec2 place) { return glm::length(place - pixel) <= reach * scale(); };
    if (near(knob_pixel(frame, box))) return TransformGrip{TransformGrip::Kind::turn, {}, box, at};
    for (const dvec2& handle : handles)
        if (near(frame.view.disk_pixel(box.at(handle))))
            return TransformGrip{TransformGrip::Kind::pull, handle, box, at};
    const dvec2 own = box.own(at);
    if (std::max(std::abs(own.x), std::abs(own.y)) <= 1)
        return TransformGrip{TransformGrip::Kind::move, {}, box, at};
    return {};
}

DiskBox dragged(const TransformGrip& grip, dvec2 to) {
    const bool shift = ImGui::GetIO().KeyShift;
    DiskBox box = grip.before;
    switch (grip.kind) {
        case TransformGrip::Kind::move:
            box.middle += to - grip.from;
            return box;
        case TransformGrip::Kind::pull:
            // The handle keeps its distance from the pointer.
            return pulled(box, grip.handle, box.at(grip.handle) + to - grip.from, shift);
        case TransformGrip::Kind::turn:
            break;
    }
    const auto angle = [&](dvec2 at) { return std::atan2(at.y - box.middle.y, at.x - box.middle.x); };
    const double step = turn_step * std::numbers::pi / 180, turn = angle(to) - angle(grip.from);
    return turned(box, shift ? std::round(turn / step) * step : turn);
}

std::shared_ptr<const Raster> raster_in(const Distribution& distribution, std::size_t layer, LayerPart part) {
    if (layer >= distribution.layers.size()) return nullptr;
    const Picture* const picture = part_picture(distribution.layers[layer], part);
    return picture != nullptr ? picture->raster : nullptr;
}

// What the box stands about; another one begins where any of it changes.
TransformSubject subject_of(const CanvasState& state, const Distribution& distribution, std::size_t chosen) {
    TransformSubject subject{
        .layer = chosen, .part = part_in_hand(state, distribution, chosen), .selection = state.selection};
    subject.raster = raster_in(distribution, chosen, subject.part);
    if (subject.raster) subject.frame = layer_frame(distribution.layers[chosen]);
    return subject;
}

void begin(CanvasState& state, TransformSubject subject, const Distribution& distribution) {
    if (!subject.raster) return;
    const auto raster = part_raster(distribution.layers[subject.layer], subject.part);
    const auto selected =
        subject.selection ? subject.selection->texels(subject.frame, raster->width) : nullptr;
    const auto transform = Transform::of(raster, subject.frame, selected);
    if (!transform) return;
    state.transform =
        HeldTransform{.subject = std::move(subject), .transform = *transform, .box = transform->box()};
}

void show(HeldTransform& held, Blend blend, Distribution& distribution, std::size_t& chosen) {
    if (!held.paint) {
        held.origin = distribution;
        held.paint = LayerPaint::open(distribution, chosen, held.subject.part);
        if (!held.paint) return;
    }
    held.subject.raster = held.transform.carried(held.box, blend);
    held.blend = blend;
    distribution.layers[held.subject.layer] = held.paint->with(held.subject.raster);
}

void take_back(CanvasState& state, Distribution& distribution) {
    if (transform_pending(state)) distribution = *std::move(state.transform->origin);
    state.transform.reset();
}

// Of the keys and of what has become of the subject. Whoever takes the tool away or changes the layer leaves
// it as it is shown: applied.
void follow(CanvasState& state, Distribution& distribution, std::size_t chosen) {
    const bool free =
        !ImGui::GetIO().WantTextInput &&
        !ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
    if (transform_pending(state) && free && !ImGui::IsAnyMouseDown()) {
        if (is_key_pressed(key::enter, false))
            apply_transform(state);
        else if (take_escape())
            take_back(state, distribution);
    }
    TransformSubject subject = subject_of(state, distribution, chosen);
    if (state.transform && state.transform->subject == subject) return;
    if (state.transform) {
        // Not where it has been undone.
        const TransformSubject& old = state.transform->subject;
        if (raster_in(distribution, old.layer, old.part) == old.raster) apply_transform(state);
        state.transform.reset();
    }
    begin(state, std::move(subject), distribution);
}

}  // namespace

void apply_transform(CanvasState& state) {
    if (transform_pending(state) && state.selection && state.selection == state.transform->subject.selection)
        state.selection = carried(*state.selection, state.transform->transform.box(), state.transform->box);
    state.transform.reset();
}

bool transform_pending(const CanvasState& state) { return state.transform && state.transform->paint; }

bool transform_paint(CanvasState& state, const CanvasFrame& frame, Distribution& distribution,
                     std::size_t& chosen) {
    const bool active = ImGui::IsItemActive(), down = ImGui::IsMouseDown(ImGuiMouseButton_Left);
    if (state.transform && state.transform->grip && !active && down) {
        // Escape has let go of this drag and taken all back: those before it hold.
        HeldTransform& held = *state.transform;
        held.box = held.grip->before;
        held.grip.reset();
        if (held.paint) {
            held.paint.reset();
            if (held.box != held.transform.box())
                show(held, held.blend, distribution, chosen);
            else
                held.subject = subject_of(state, distribution, chosen);
        }
        return true;
    }
    follow(state, distribution, chosen);
    if (!state.transform) return false;
    HeldTransform& held = *state.transform;
    const glm::dvec2 pixel = frame.pixel(ImGui::GetIO().MousePos);
    if (frame.hovered && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
        held.grip = grip_under(frame, held.box, pixel);
        if (!held.grip && transform_pending(state)) {
            apply_transform(state);
            return true;
        }
    }
    if (held.grip && active && down) {
        const DiskBox box = dragged(*held.grip, frame.view.disk_under(pixel));
        if (box != held.box) {
            held.box = box;
            show(held, state.brush.blend, distribution, chosen);
        }
    } else {
        held.grip.reset();
        if (transform_pending(state) && held.blend != state.brush.blend)
            show(held, state.brush.blend, distribution, chosen);
    }
    return held.grip || (frame.hovered && grip_under(frame, held.box, pixel));
}

void draw_transform(const CanvasState& state, const CanvasFrame& frame) {
    if (!state.transform || state.tool != CanvasTool::transform) return;
    const DiskBox& box = state.transform->box;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const auto screen = [&](glm::dvec2 pixel) {
        return ImVec2(frame.low.x + static_cast<float>(pixel.x), frame.low.y + static_cast<float>(pixel.y));
    };
    const auto size = static_cast<float>(scale());
    const auto lines = [&](ImU32 colour, float width) {
        for (std::size_t corner = 0; corner < handles.size(); corner += 2) {
            const dvec2 a = handles[corner], b = handles[(corner + 2) % handles.size()];
            for (int i = 0; i <= side_steps; ++i)
                list.PathLineTo(
                    screen(frame.view.disk_pixel(box.at(a + (b - a) * (i / double(side_steps))))));
        }
        list.PathStroke(colour, ImDrawFlags_Closed, width * size);
    };
    lines(IM_COL32(0, 0, 0, 150), 3.2f);
    lines(ImGui::GetColorU32(palette::text), 1.3f);
    std::optional<TransformGrip> hot = state.transform->grip;
    if (!hot && frame.hovered) hot = grip_under(frame, box, frame.pixel(ImGui::GetIO().MousePos));
    const auto knob = [&](glm::dvec2 pixel, float radius, bool lit) {
        list.AddCircleFilled(screen(pixel), (radius + 1.5f) * size, IM_COL32(0, 0, 0, 170));
        list.AddCircleFilled(screen(pixel), radius * size,
                             ImGui::GetColorU32(lit ? palette::accent_bright : palette::text));
    };
    for (const dvec2& handle : handles)
        knob(frame.view.disk_pixel(box.at(handle)), 4,
             hot && hot->kind == TransformGrip::Kind::pull && hot->handle == handle);
    knob(knob_pixel(frame, box), 5, hot && hot->kind == TransformGrip::Kind::turn);
}

ToolbarRow transform_row(CanvasState& state, Distribution& distribution) {
    ToolbarRow row;
    row.add(button_width("Apply"), [&state] {
        if (button("Apply##Apply transform",
                   "Keeps what is shown, in one step of undo: Enter, or a click outside.",
                   transform_pending(state)))
            apply_transform(state);
    });
    row.add(button_width("Cancel"), [&state, &distribution] {
        if (button("Cancel##Cancel transform", "Everything as it was: Escape.", transform_pending(state)))
            take_back(state, distribution);
    });
    const float list = std::floor(button_width("Maximum") + ImGui::GetFrameHeight());
    row.add(list, [&state, list] { combine_choice(state.brush, "Combine carried", list); });
    row.add_hint(state.transform ? "Shift keeps the ratio." : "Nothing is painted here.");
    return row;
}

}  // namespace nacre::ui
