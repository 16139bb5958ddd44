// Around what the hand goes around.
#include "core/paint/select_tool.h"

namespace nacre {
namespace {

std::vector<glm::dvec2> outline(std::span<const glm::dvec2> way) { return {way.begin(), way.end()}; }

void icon(const IconPen& pen) {
    pen.line({{0.46f, 0.64f},
              {0.26f, 0.60f},
              {0.15f, 0.44f},
              {0.24f, 0.26f},
              {0.48f, 0.18f},
              {0.74f, 0.24f},
              {0.85f, 0.42f},
              {0.74f, 0.58f},
              {0.46f, 0.64f}});
    pen.line({{0.46f, 0.64f}, {0.36f, 0.72f}, {0.44f, 0.86f}});
}

}  // namespace

const SelectToolInfo select_lasso_tool{
    .face = {.name = "Select lasso",
             .key = 'Q',
             .about = "Marks what the hand goes around.",
             .more = "Shift adds to what is selected, Ctrl or Alt takes away, a click selects nothing.",
             .icon = icon},
    .outline = outline};

}  // namespace nacre
