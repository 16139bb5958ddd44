// Between the press and the pointer.
#include "core/paint/select_tool.h"

namespace nacre {
namespace {

std::vector<glm::dvec2> outline(std::span<const glm::dvec2> way) {
    const glm::dvec2 a = way.front(), b = way.back();
    return {a, {b.x, a.y}, b, {a.x, b.y}};
}

void icon(const IconPen& pen) {
    for (const float y : {0.22f, 0.78f})
        for (const float x : {0.18f, 0.42f, 0.66f}) pen.line({{x, y}, {x + 0.16f, y}});
    for (const float x : {0.18f, 0.82f})
        for (const float y : {0.22f, 0.44f, 0.64f}) pen.line({{x, y}, {x, y + 0.14f}});
}

}  // namespace

const SelectToolInfo select_rectangle_tool{
    .face = {.name = "Select rectangle",
             .key = 'W',
             .about = "Marks a rectangle that every tool keeps to.",
             .more = "Shift adds to what is selected, Ctrl or Alt takes away, a click selects nothing.",
             .icon = icon,
             .begins_group = true},
    .outline = outline};

}  // namespace nacre
