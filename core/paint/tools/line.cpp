// From the press to the pointer.
#include <algorithm>
#include <cmath>

#include "core/paint/paint_tool.h"

namespace nacre {
namespace {

double distance(const ShapeSize& size, double middle, double turn) {
    const RayPlace place = ray_place(middle, turn);
    if (place.along <= 0) return middle / size.radius;
    if (place.along <= size.length) return std::abs(place.off) / size.radius;
    const double cosine = std::cos(place.off) * std::cos(place.along - size.length);
    return std::acos(std::clamp(cosine, -1.0, 1.0)) / size.radius;
}

void icon(const IconPen& pen) { pen.line({{0.20f, 0.80f}, {0.80f, 0.20f}}); }

}  // namespace

const PaintToolInfo line_tool{.face = {.name = "Line",
                                       .key = 'L',
                                       .about = "A line from press to release.",
                                       .more = "As wide and as hard as the brush.",
                                       .icon = icon,
                                       .begins_group = true},
                              .work = distance};

}  // namespace nacre
