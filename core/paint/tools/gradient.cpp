// From full paint at the press to none at the pointer.
#include <algorithm>
#include <cmath>

#include "core/paint/paint_tool.h"

namespace nacre {
namespace {

// By the angle along the way, the same on each circle across it.
double amount(const ShapeSize& size, double middle, double turn) {
    if (!(size.length > 0)) return 0;
    if (size.form == GradientForm::radial) return std::clamp(1 - middle / size.length, 0.0, 1.0);
    const double half = 0.5 * size.length;
    // The sine of the angle from the circle midway.
    const double beyond =
        std::sin(middle) * std::cos(turn) * std::cos(half) - std::cos(middle) * std::sin(half);
    return std::clamp(0.5 - std::asin(std::clamp(beyond, -1.0, 1.0)) / size.length, 0.0, 1.0);
}

void icon(const IconPen& pen) {
    pen.line({{0.16f, 0.24f}, {0.84f, 0.24f}, {0.84f, 0.76f}, {0.16f, 0.76f}}, true);
    pen.fill({{0.16f, 0.24f}, {0.42f, 0.24f}, {0.42f, 0.76f}, {0.16f, 0.76f}});
    pen.line({{0.52f, 0.24f}, {0.52f, 0.76f}});
    pen.line({{0.66f, 0.24f}, {0.66f, 0.76f}});
}

}  // namespace

const PaintToolInfo gradient_tool{
    .face = {.name = "Gradient",
             .key = 'D',
             .about = "Fades from the press to the pointer.",
             .more =
                 "Full paint behind the press, or about it where it is radial, and none beyond the pointer.",
             .icon = icon},
    .needs = ToolNeed::form,
    .work = GradientTool{.amount = amount}};

}  // namespace nacre
