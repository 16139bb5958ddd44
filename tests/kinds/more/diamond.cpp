// A square on its corner.
#include "core/paint/select_tool.h"

namespace nacre {
namespace {

std::vector<glm::dvec2> outline(std::span<const glm::dvec2> way) {
    const glm::dvec2 a = way.front(), b = way.back(), middle = 0.5 * (a + b);
    return {{middle.x, a.y}, {b.x, middle.y}, {middle.x, b.y}, {a.x, middle.y}};
}

void icon(const IconPen& pen) { pen.line({{0.5f, 0.2f}, {0.8f, 0.5f}, {0.5f, 0.8f}, {0.2f, 0.5f}}, true); }

}  // namespace

const SelectToolInfo select_diamond_tool{.face = {.name = "Select diamond",
                                                  .key = 'J',
                                                  .about = "Marks a square on its corner.",
                                                  .more = "Its corners lie midway.",
                                                  .icon = icon},
                                         .outline = outline};

}  // namespace nacre
