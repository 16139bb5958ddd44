// Rays from the press, one of them to the pointer, that taper to their ends.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/paint/paint_tool.h"

namespace nacre {
namespace {

double distance(const ShapeSize& size, double middle, double turn) {
    constexpr double shortest = 1e-9;  // radians; of a star that has not been drawn out yet
    const RayPlace place = ray_place(middle, std::remainder(turn, 2 * std::numbers::pi / size.rays));
    if (place.along <= 0) return middle / size.radius;
    const double width = size.radius * (1 - place.along / std::max(size.length, shortest));
    return width > 0 ? std::abs(place.off) / width : HUGE_VAL;
}

void icon(const IconPen& pen) {
    for (int ray = 0; ray < 5; ++ray) {
        const float turn = static_cast<float>(2 * std::numbers::pi * ray / 5);
        const float x = std::sin(turn), y = -std::cos(turn);
        pen.fill({{0.5f + 0.36f * x, 0.5f + 0.36f * y},
                  {0.5f - 0.07f * y, 0.5f + 0.07f * x},
                  {0.5f + 0.07f * y, 0.5f - 0.07f * x}});
    }
}

}  // namespace

const PaintToolInfo star_tool{.face = {.name = "Star",
                                       .key = 'K',
                                       .about = "Rays from the press that taper off: a sparkle.",
                                       .more = "The drag gives their length.",
                                       .icon = icon},
                              .needs = ToolNeed::rays,
                              .work = distance};

}  // namespace nacre
