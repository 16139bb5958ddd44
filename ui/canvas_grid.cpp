#include "ui/canvas_grid.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "ui/canvas_path.h"
#include "ui/theme.h"

namespace nacre::ui {
namespace {

constexpr int steps = 96;  // of a full circle
constexpr Colour faint{1, 1, 1, 0.10f};
constexpr Colour plain{1, 1, 1, 0.19f};
constexpr Colour rim{1, 1, 1, 0.42f};
constexpr float label_size = 0.8f;  // of the text's size

// `corner` with all of a text of this extent between low and high.
float kept_inside(float corner, float extent, float low, float high) {
    return std::max(std::min(corner, high - extent - scaled(2)), low + scaled(2));
}

// All of it shows, also beside the canvas's edge, where its middle does.
void label(const CanvasFrame& frame, ImVec2 at, const std::string& text, const Colour& colour) {
    const float size = ImGui::GetFontSize() * label_size;
    const ImVec2 extent = ImGui::GetFont()->CalcTextSizeA(size, FLT_MAX, 0, text.c_str());
    if (at.x < frame.low.x || at.y < frame.low.y || at.x > frame.high.x || at.y > frame.high.y) return;
    const ImVec2 corner(std::round(kept_inside(at.x - extent.x / 2, extent.x, frame.low.x, frame.high.x)),
                        std::round(kept_inside(at.y - extent.y / 2, extent.y, frame.low.y, frame.high.y)));
    ImDrawList& list = *ImGui::GetWindowDrawList();
    // A dark edge keeps the numbers readable on a bright p.
    for (const ImVec2 off : {ImVec2(1, 0), {-1, 0}, {0, 1}, {0, -1}})
        list.AddText(ImGui::GetFont(), size, {corner.x + off.x, corner.y + off.y}, IM_COL32(0, 0, 0, 150),
                     text.c_str());
    list.AddText(ImGui::GetFont(), size, corner, ImGui::GetColorU32(colour), text.c_str());
}

void ring(const CanvasFrame& frame, double theta, const Colour& colour, float width) {
    draw_path(
        frame, [&](double t) { return polar_direction(theta, 360 * t); }, steps, ImGui::GetColorU32(colour),
        width);
}

// Numbers stand at the rim, on the outside of the picture.
void label_spoke(const CanvasFrame& frame, int phi, double end) {
    const dvec3 h = polar_direction(end, phi);
    if (frame.view.hidden(h)) return;
    const ImVec2 at = frame.screen(h), middle = frame.screen({0, 0, 1});
    const float x = at.x - middle.x, y = at.y - middle.y, length = std::hypot(x, y);
    if (length < 1) return;
    const float gap = ImGui::GetFontSize() * 0.95f;
    const std::string name = phi == 0 ? "x" : phi == 90 ? "y" : std::to_string(phi) + "\u00b0";
    label(frame, {at.x + x / length * gap, at.y + y / length * gap}, name, palette::text_dim);
}

// Of a highlight only what tells middle and rim.
void draw_highlight_grid(const CanvasFrame& frame, float width) {
    const double end = frame.view.camera().below ? 179.99 : 90;
    for (const double theta : {30.0, 60.0}) ring(frame, theta, faint, width);
    for (int phi = 0; phi < 360; phi += 90)
        draw_path(
            frame, [&](double t) { return polar_direction(t * end, phi); }, steps / 2,
            ImGui::GetColorU32(faint), width);
    ring(frame, 90, rim, 1.4f * width);
    if (end > 90 && !frame.view.camera().dome) ring(frame, end, plain, width);
}

void draw_facet_grid(const CanvasFrame& frame, float width) {
    const bool below = frame.view.camera().below;
    const double end = below ? 180 : 90;
    // On the disk the nadir is a circle, which only a theta just short of it draws.
    const double outermost = std::min(end, 179.99);
    for (int theta = 15; theta < end; theta += 15)
        if (theta != 90) ring(frame, theta, theta % 30 == 0 ? plain : faint, width);
    for (int phi = 0; phi < 360; phi += 30)
        draw_path(
            frame, [&](double t) { return polar_direction(t * outermost, phi); }, steps / 2,
            ImGui::GetColorU32(phi % 90 == 0 ? plain : faint), width);
    ring(frame, 90, rim, 1.4f * width);
    if (below && !frame.view.camera().dome) ring(frame, outermost, plain, width);
    for (int phi = 0; phi < 360; phi += 30) label_spoke(frame, phi, outermost);
    for (int theta = 30; theta < end; theta += 30) {
        const dvec3 h = polar_direction(theta, 45);
        if (!frame.view.hidden(h))
            label(frame, frame.screen(h), std::to_string(theta) + "\u00b0", palette::text);
    }
}

}  // namespace

void draw_grid(const CanvasFrame& frame) {
    const float width = std::max(1.0f, ImGui::GetFontSize() / 15);
    if (frame.view.camera().highlight)
        draw_highlight_grid(frame, width);
    else
        draw_facet_grid(frame, width);
}

void draw_mark(const CanvasFrame& frame, dvec3 h) {
    if (frame.view.hidden(h)) return;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 at = frame.screen(h);
    const float scale = ImGui::GetFontSize() / 15, reach = 11 * scale, gap = 4 * scale;
    for (const bool edge : {true, false}) {
        const ImU32 colour = edge ? IM_COL32(0, 0, 0, 170) : ImGui::GetColorU32(palette::accent_bright);
        const float width = (edge ? 4.5f : 2.2f) * scale;
        list.AddCircle(at, gap, colour, 0, width);
        for (const ImVec2 way : {ImVec2(1, 0), {-1, 0}, {0, 1}, {0, -1}})
            list.AddLine({at.x + gap * way.x, at.y + gap * way.y},
                         {at.x + reach * way.x, at.y + reach * way.y}, colour, width);
    }
}

double tilt_of_mean(const FacetDistribution& p) { return polar_angle(p.mean()); }

void draw_mean_normal(const CanvasFrame& frame, const FacetDistribution& p) {
    const double tilt = tilt_of_mean(p);
    const Colour& colour = tilt < tilt_noticed ? palette::green : palette::amber;
    const dvec3 mean = glm::normalize(p.mean());
    const float scale = ImGui::GetFontSize() / 15;
    const ImU32 ink = ImGui::GetColorU32(colour), outline = ImGui::GetColorU32(ImVec4(0, 0, 0, 0.55f));
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 from = frame.screen({0, 0, 1}), to = frame.screen(mean);
    const ImVec2 along(to.x - from.x, to.y - from.y);
    const float length = std::hypot(along.x, along.y);
    if (length < 9 * scale) {
        list.AddCircle(to, 4.5f * scale, outline, 0, 4 * scale);
        list.AddCircle(to, 4.5f * scale, ink, 0, 2 * scale);
        return;
    }
    const ImVec2 unit(along.x / length, along.y / length);
    const ImVec2 foot(to.x - unit.x * 9 * scale, to.y - unit.y * 9 * scale);
    list.AddLine(from, foot, outline, 4.5f * scale);
    list.AddLine(from, foot, ink, 2.2f * scale);
    list.AddTriangleFilled(to, {foot.x - unit.y * 5 * scale, foot.y + unit.x * 5 * scale},
                           {foot.x + unit.y * 5 * scale, foot.y - unit.x * 5 * scale}, ink);
}

}  // namespace nacre::ui
