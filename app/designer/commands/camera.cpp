#include <array>

#include "app/designer/command.h"
#include "app/designer/preview_mouse.h"

namespace nacre {
namespace {

constexpr double turn = 40;  // pixels of a drag

struct Move {
    const char* label;
    const char* about;
    glm::dvec2 drag;
    double wheel;
};

constexpr std::array<Move, 6> moves{{{"Turn left", "Turns the object to the left.", {-turn, 0}, 0},
                                     {"Turn right", "Turns the object to the right.", {turn, 0}, 0},
                                     {"Tip up", "Shows more of the object from below.", {0, -turn}, 0},
                                     {"Tip down", "Shows more of the object from above.", {0, turn}, 0},
                                     {"Closer", "Makes the object larger.", {0, 0}, 1},
                                     {"Farther", "Makes the object smaller.", {0, 0}, -1}}};

std::vector<ui::CommandChoice> choices(const Designer&) {
    std::vector<ui::CommandChoice> list;
    for (const Move& move : moves) list.push_back({move.label, move.about});
    return list;
}

}  // namespace

const Command camera_command{
    .info = {.menu = "View/Camera", .label = "Camera", .keys = nullptr, .about = nullptr},
    .choices = choices,
    .perform = [](Designer& designer, std::size_t which) {
        const Move& move = moves.at(which);
        orbit(designer.scene, move.drag);
        zoom(designer.scene, move.wheel);
    }};

}  // namespace nacre
