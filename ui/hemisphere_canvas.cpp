#include "ui/hemisphere_canvas.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/paint/colour_map.h"
#include "ui/brush_mark.h"
#include "ui/brush_surface.h"
#include "ui/canvas_grid.h"
#include "ui/canvas_handles.h"
#include "ui/canvas_paint.h"
#include "ui/canvas_path.h"
#include "ui/canvas_select.h"
#include "ui/canvas_toolbar.h"
#include "ui/canvas_tools.h"
#include "ui/canvas_transform.h"
#include "ui/item_map.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace nacre::ui {
namespace {

constexpr double zoom_per_notch = 1.15;
constexpr int bar_steps = 48;
constexpr double unseen = 1e-9;  // of the peak: what lies below is read as 0

void move_camera(CanvasState& state, const CanvasFrame& frame) {
    const ImGuiIO& io = ImGui::GetIO();
    HemisphereCamera& camera = state.camera;
    if (ImGui::IsItemHovered() && io.MouseWheel != 0)
        camera = zoomed(frame.view, frame.pixel(io.MousePos),
                        std::pow(zoom_per_notch, static_cast<double>(io.MouseWheel)));
    if (!ImGui::IsItemActive()) return;
    const glm::dvec2 moved(io.MouseDelta.x, io.MouseDelta.y);
    if (ImGui::IsMouseDown(ImGuiMouseButton_Right))
        camera = dragged(frame.view, moved);
    else if (ImGui::IsMouseDown(ImGuiMouseButton_Middle))
        camera = panned(frame.view, moved);
}

std::optional<dvec3> cursor_of(const CanvasFrame& frame) {
    if (!frame.hovered) return {};
    return frame.view.direction(frame.pixel(ImGui::GetIO().MousePos));
}

BrushSurface surface_of(const CanvasFrame& frame) {
    return {
        .surface = Surface::canvas,
        .hovered = frame.hovered,
        .active = ImGui::IsItemActive(),
        .pointed_at = frame.cursor,
        .pixel = frame.pixel(ImGui::GetIO().MousePos),
        .normal = [&frame](glm::dvec2 pixel) { return std::optional(frame.view.nearest_direction(pixel)); }};
}

// Returns whether the pointer is the tool's.
bool work_on_canvas(CanvasState& state, const CanvasFrame& frame, const CanvasSight& sight,
                    Distribution& distribution, std::size_t& chosen) {
    if (state.tool == CanvasTool::transform) return transform_paint(state, frame, distribution, chosen);
    apply_transform(state);
    if (state.tool == CanvasTool::handles) return handle_layers(state, frame, distribution, chosen);
    if (selects_with(state.tool)) return select_area(state, frame);
    return use_tool(state, surface_of(frame), sight.p, distribution, chosen);
}

// A line of words and numbers, and one of buttons.
float legend_height() {
    return ImGui::GetTextLineHeight() + ImGui::GetFrameHeight() + 2 * ImGui::GetStyle().ItemSpacing.y;
}

void text_at(ImVec2 at, const std::string& text, const Colour& colour) {
    ImGui::GetWindowDrawList()->AddText(at, ImGui::GetColorU32(colour), text.c_str());
}

std::string readout(const CanvasState& state, const CanvasFrame& frame, const CanvasContents& contents) {
    if (contents.design)
        if (std::string held = handle_text(state, *contents.design); !held.empty()) return held;
    const std::optional<dvec3>& pointed = frame.cursor ? frame.cursor : contents.marked;
    if (!pointed) return {};
    const dvec3 h = *pointed;
    std::string text = fmt::format("\u03b8 {:.1f}\u00b0   \u03c6 {:.1f}\u00b0", polar_angle(h), azimuth(h));
    if (!contents.p) return text;
    const double p = contents.p->density(h);
    text += fmt::format("   p {:.3g} /sr", p < unseen * contents.scale.peak ? 0 : p);
    return text;
}

// The colours from 0 to the peak, with the cursor's place among them.
void colour_bar(ImVec2 low, ImVec2 high, const CanvasFrame& frame, const CanvasContents& contents) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float step = (high.x - low.x) / bar_steps;
    const auto colour = [](int i) {
        const glm::u8vec3 c = inferno(static_cast<double>(i) / bar_steps);
        return IM_COL32(c.x, c.y, c.z, 255);
    };
    for (int i = 0; i < bar_steps; ++i) {
        const float x = low.x + static_cast<float>(i) * step;
        list.AddRectFilledMultiColor({x, low.y}, {x + step, high.y}, colour(i), colour(i + 1), colour(i + 1),
                                     colour(i));
    }
    list.AddRect(low, high, ImGui::GetColorU32(palette::line));
    if (!frame.cursor || !contents.p) return;
    const auto at = static_cast<float>(contents.scale.position(contents.p->density(*frame.cursor)));
    const float x = low.x + at * (high.x - low.x);
    list.AddLine({x, low.y - 3}, {x, high.y + 3}, ImGui::GetColorU32(palette::text), 2);
}

// What the canvas says while nothing is pointed at.
std::string at_rest(const CanvasFrame& frame, const FacetDistribution& p) {
    if (frame.view.camera().highlight) {
        for (const char* words : {"The middle shines like a mirror; further out, a wider glow.",
                                  "Middle: like a mirror. Further out: a glow."})
            if (ImGui::CalcTextSize(words).x < 0.65f * (frame.high.x - frame.low.x)) return words;
        return "";
    }
    const double tilt = tilt_of_mean(p);
    return tilt < tilt_noticed ? "mean normal along n" : fmt::format("mean normal {:.1f}\u00b0 off n", tilt);
}

void legend(const CanvasState& state, const CanvasFrame& frame, const CanvasContents& contents) {
    const float size = ImGui::GetFontSize(), top = frame.high.y + ImGui::GetStyle().ItemSpacing.y * 0.5f;
    const float left = frame.low.x + size * 0.8f, right = frame.high.x - size * 0.8f;
    const std::string least =
        contents.scale.kind == ScaleKind::logarithmic ? fmt::format("{:.2g}", contents.scale.value(0)) : "0";
    const std::string most = fmt::format("{:.3g} /sr", contents.scale.peak);
    const float bar = left + ImGui::CalcTextSize(least.c_str()).x + size * 0.5f, width = size * 6;
    std::string text = readout(state, frame, contents);
    Colour colour = palette::text;
    if (text.empty() && contents.p) {
        text = at_rest(frame, *contents.p);
        colour = palette::text_dim;
        if (state.refusal && contents.mean == state.refusal->mean)
            text = state.refusal->why, colour = palette::amber;
    }
    const float text_left = right - ImGui::CalcTextSize(text.c_str()).x;
    text_at({text_left, top}, text, colour);
    if (contents.scale.kind == ScaleKind::material) return;  // its colours stand for no numbers
    // Where the canvas is narrow the numbers go first.
    const float bar_end = bar + width + size * 0.5f + ImGui::CalcTextSize(most.c_str()).x;
    if (!text.empty() && bar_end + size * 0.5f > text_left) return;
    text_at({left, top}, least, palette::text_dim);
    colour_bar({bar, top + size * 0.15f}, {bar + width, top + size * 0.95f}, frame, contents);
    text_at({bar + width + size * 0.5f, top}, most, palette::text_dim);
}

// Says what the tools paint while that is not the layer itself.
void draw_mask_label(const CanvasState& state, const CanvasFrame& frame, const CanvasContents& contents) {
    if (!contents.design || part_in_hand(state, *contents.design, contents.chosen) != LayerPart::mask) return;
    const float scale = ImGui::GetFontSize() / 15, border = 8 * scale;
    const std::string text = fmt::format("Mask of layer {}: what is veiled is hidden", contents.chosen + 1);
    const ImVec2 low(frame.low.x + border, frame.low.y + border), size = ImGui::CalcTextSize(text.c_str());
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(low, {low.x + size.x + 2 * border, low.y + size.y + border},
                       ImGui::GetColorU32(palette::accent_dim), ImGui::GetStyle().FrameRounding);
    text_at({low.x + border, low.y + 0.5f * border}, text, palette::text);
}

}  // namespace

ImVec2 CanvasFrame::screen(dvec3 h) const {
    const glm::dvec2 at = view.pixel(h);
    return {low.x + static_cast<float>(at.x), low.y + static_cast<float>(at.y)};
}

glm::dvec2 CanvasFrame::pixel(ImVec2 screen) const { return {screen.x - low.x, screen.y - low.y}; }

CanvasFrame begin_canvas(CanvasState& state, const CanvasSight& sight, Distribution& distribution,
                         std::size_t& chosen) {
    const float border = ImGui::GetFontSize() * 0.6f;
    ImGui::SetCursorPos({ImGui::GetCursorPosX() + border, ImGui::GetCursorPosY() + border});
    ImGui::BeginGroup();
    canvas_toolbar(state, sight.mean, distribution, chosen);
    ImGui::EndGroup();
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const ImVec2 size(std::max(room.x, 1.0f), std::max(room.y - legend_height(), 1.0f));
    ImGui::InvisibleButton("Canvas", size,
                           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                               ImGuiButtonFlags_MouseButtonMiddle);
    note_surface("Canvas");
    const ImVec2 below(low.x + border,
                       low.y + size.y + ImGui::GetTextLineHeight() + ImGui::GetStyle().ItemSpacing.y);
    const glm::dvec2 extent(size.x, size.y);
    CanvasFrame frame{.low = low,
                      .high = {low.x + size.x, low.y + size.y},
                      .view = HemisphereView(state.camera, extent),
                      .hovered = ImGui::IsItemHovered(),
                      .cursor = {}};
    frame.cursor = cursor_of(frame);
    move_camera(state, frame);
    const bool taken = work_on_canvas(state, frame, sight, distribution, chosen);
    if (taken) name_edit_by_tool(state.tool);
    if (frame.hovered && ((!taken && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) ||
                          ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Middle)))
        state.camera = state.camera.whole();
    ImGui::SetCursorScreenPos(below);
    view_choices(state);
    frame.view = HemisphereView(state.camera, extent);
    frame.cursor = cursor_of(frame);
    return frame;
}

void end_canvas(const CanvasState& state, const CanvasFrame& frame, const CanvasContents& contents) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.PushClipRect(frame.low, frame.high, true);
    list._FringeScale = 1 / ImGui::GetIO().DisplayFramebufferScale.x;  // soft edges one pixel wide, no more
    if (contents.picture != nullptr)
        list.AddImage(contents.picture, frame.low,
                      {frame.low.x + contents.picture_size.x, frame.low.y + contents.picture_size.y});
    draw_grid(frame);
    draw_selection(state, frame);
    if (contents.p && !state.camera.highlight) draw_mean_normal(frame, *contents.p);
    if (contents.design && state.tool == CanvasTool::handles)
        draw_handles(state, frame, *contents.design, contents.chosen);
    else if (contents.design)
        draw_brush(state, frame, contents);
    draw_transform(state, frame);
    draw_mask_label(state, frame, contents);
    if (contents.marked) draw_mark(frame, *contents.marked);
    list._FringeScale = 1;
    list.PopClipRect();
    legend(state, frame, contents);
}

}  // namespace nacre::ui
