#include "ui/canvas_select.h"

#include <algorithm>
#include <cmath>

#include "ui/canvas_tools.h"
#include "ui/canvas_transform.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace nacre::ui {
namespace {

constexpr double pixels_a_step = 1.5;  // between two corners of a lasso
constexpr double click_pixels = 3;     // a shorter drag is a click
constexpr float dash = 4;              // length of one, and of the gap behind it

SelectMode mode_of_keys() {
    const ImGuiIO& io = ImGui::GetIO();
    if (io.KeyShift) return SelectMode::add;
    return io.KeyCtrl || io.KeyAlt ? SelectMode::remove : SelectMode::replace;
}

bool is_click(const std::vector<glm::dvec2>& way) {
    return std::all_of(way.begin(), way.end(),
                       [&](glm::dvec2 at) { return glm::length(at - way.front()) < click_pixels; });
}

void end_selecting(CanvasState& state, const CanvasFrame& frame) {
    const auto [way, mode] = *std::move(state.selecting);
    state.selecting.reset();
    if (!is_click(way))
        state.selection =
            select(state.selection.get(), mode, frame.view, info(*selects_with(state.tool)).outline(way));
    else if (mode == SelectMode::replace)
        state.selection.reset();
}

// A line of dashes, white on dark, so that it shows on every colour.
class DashedLine {
  public:
    void go_to(ImVec2 at) {
        if (points_.empty() || std::hypot(at.x - points_.back().x, at.y - points_.back().y) >= 1)
            points_.push_back(at);
    }

    // Draws what there is, and begins another.
    void end() {
        const float scale = ImGui::GetFontSize() / 15;
        ImGui::GetWindowDrawList()->AddPolyline(points_.Data, points_.Size, IM_COL32(0, 0, 0, 190), 0,
                                                2.2f * scale);
        float gone = 0;
        for (int i = 1; i < points_.Size; ++i) gone = dashes(points_[i - 1], points_[i], gone, dash * scale);
        points_.clear();
    }

  private:
    static constexpr ImU32 white = IM_COL32(255, 255, 255, 240);

    // From one point to the next, `gone` along the line already. Returns how far along it is then.
    static float dashes(ImVec2 from, ImVec2 to, float gone, float length) {
        ImDrawList& list = *ImGui::GetWindowDrawList();
        const float way = std::hypot(to.x - from.x, to.y - from.y);
        for (float at = 0; at < way;) {
            const float within = std::fmod(gone + at, 2 * length);
            const bool drawn = within < length;
            const float next = std::min(at + std::max((drawn ? length : 2 * length) - within, 0.05f), way);
            const auto place = [&](float t) {
                return ImVec2(from.x + (to.x - from.x) * t / way, from.y + (to.y - from.y) * t / way);
            };
            if (drawn) list.AddLine(place(at), place(next), white, 1.2f * ImGui::GetFontSize() / 15);
            at = next;
        }
        return gone + way;
    }

    ImVector<ImVec2> points_;
};

// `place` is where each of its points is shown.
template <class Place>
void draw_outline(const CanvasFrame& frame, const std::vector<dvec2>& outline, const Place& place) {
    DashedLine line;
    const bool below = frame.view.camera().below;
    for (std::size_t i = 0; i <= outline.size(); ++i) {
        const dvec2 at = place(outline[i % outline.size()]);
        // What ends at the horizon lies on it.
        const double r = glm::length(at);
        const dvec3 h = disk_direction(!below && r > 1 ? at * ((1 - 1e-9) / r) : at);
        if (frame.view.hidden(h))
            line.end();
        else
            line.go_to(frame.screen(h));
    }
    line.end();
}

}  // namespace

bool select_area(CanvasState& state, const CanvasFrame& frame) {
    const glm::dvec2 pixel = frame.pixel(ImGui::GetIO().MousePos);
    if (frame.hovered && ImGui::IsMouseClicked(ImGuiMouseButton_Left))
        state.selecting = HeldSelection{{pixel}, mode_of_keys()};
    if (!state.selecting) return frame.hovered;
    const bool active = ImGui::IsItemActive();
    if (!active && ImGui::IsMouseDown(ImGuiMouseButton_Left)) {  // Escape has let go of it
        state.selecting.reset();
        return true;
    }
    if (glm::length(pixel - state.selecting->way.back()) >= pixels_a_step || !active)
        state.selecting->way.push_back(pixel);
    if (!active) end_selecting(state, frame);
    return true;
}

void draw_selection(const CanvasState& state, const CanvasFrame& frame) {
    if (state.selection)
        for (const auto& outline : state.selection->outlines(frame.view.camera().below))
            draw_outline(frame, outline, [&](dvec2 at) {
                if (!transform_pending(state)) return at;
                return state.transform->box.at(state.transform->transform.box().own(at));
            });
    const auto tool = selects_with(state.tool);
    if (!state.selecting || !tool) return;
    std::vector<glm::dvec2> corners = info(*tool).outline(state.selecting->way);
    corners.push_back(corners.front());
    DashedLine line;
    for (const glm::dvec2& at : corners)
        line.go_to({frame.low.x + static_cast<float>(at.x), frame.low.y + static_cast<float>(at.y)});
    line.end();
}

ToolbarRow selection_row(CanvasState& state) {
    ToolbarRow row;
    row.add(button_width("All"), [&state] {
        if (button("All##Select everything", "Selects the whole canvas.")) state.selection = select_all();
    });
    row.add(button_width("None"), [&state] {
        if (button("None##Select nothing", "Selects nothing: the tools work everywhere.",
                   state.selection != nullptr))
            state.selection.reset();
    });
    row.add(button_width("Invert"), [&state] {
        if (button("Invert##Invert what is selected", "Selects what is not selected, and no longer what is.",
                   state.selection != nullptr))
            state.selection = inverted(*state.selection);
    });
    row.add_hint("Shift adds, Ctrl takes away.");
    return row;
}

}  // namespace nacre::ui
