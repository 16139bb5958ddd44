// About the press, through the pointer.
#include <cmath>

#include "core/paint/paint_tool.h"

namespace nacre {
namespace {

double distance(const ShapeSize& size, double middle, double) {
    return std::abs(middle - size.length) / size.radius;
}

void icon(const IconPen& pen) { pen.circle({0.5f, 0.5f}, 0.31f); }

}  // namespace

const PaintToolInfo ring_tool{.face = {.name = "Ring",
                                       .key = 'R',
                                       .about = "A ring about the press: a halo.",
                                       .more = "The drag gives its radius.",
                                       .icon = icon},
                              .work = distance};

}  // namespace nacre
