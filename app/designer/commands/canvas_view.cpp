#include <array>

#include "app/designer/command.h"
#include "core/paint/hemisphere_view.h"

namespace nacre {
namespace {

// As on a canvas of this size, in pixels.
constexpr glm::dvec2 size(400), middle = size / 2.0;
constexpr double drag = 40, closer = 1.3;

struct Move {
    const char* label;
    const char* about;
    HemisphereCamera (*camera)(const HemisphereView& view);
};

template <int x, int y>
HemisphereCamera dragged_by(const HemisphereView& view) {
    return dragged(view, drag * glm::dvec2(x, y));
}

constexpr std::array<Move, 7> moves{
    {{"Closer", "Enlarges the middle of the canvas.",
      [](const HemisphereView& view) { return zoomed(view, middle, closer); }},
     {"Farther", "Shows more around the middle of the canvas.",
      [](const HemisphereView& view) { return zoomed(view, middle, 1 / closer); }},
     {"Left", "Moves the disk to the left, or turns the dome.", dragged_by<-1, 0>},
     {"Right", "Moves the disk to the right, or turns the dome.", dragged_by<1, 0>},
     {"Up", "Moves the disk up, or tips the dome.", dragged_by<0, -1>},
     {"Down", "Moves the disk down, or tips the dome.", dragged_by<0, 1>},
     {"Show all", "The whole disk or dome.",
      [](const HemisphereView& view) { return view.camera().whole(); }}}};

std::vector<ui::CommandChoice> choices(const Designer&) {
    std::vector<ui::CommandChoice> list;
    for (const Move& move : moves) list.push_back({move.label, move.about});
    return list;
}

}  // namespace

const Command canvas_view_command{
    .info = {.menu = "View/Canvas", .label = "Canvas view", .keys = nullptr, .about = nullptr},
    .choices = choices,
    .perform = [](Designer& designer, std::size_t which) {
        HemisphereCamera& camera = designer.canvas.state.camera;
        camera = moves.at(which).camera(HemisphereView(camera, size));
    }};

}  // namespace nacre
