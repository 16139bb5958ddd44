// Quick shapes: drawn whole between the point of the press and the pointer.
#pragma once

#include <memory>
#include <variant>

#include "core/base/choice.h"
#include "core/image/raster.h"
#include "core/paint/brush.h"

namespace nacre {

enum class GradientForm { linear, radial };

// In the order of the enumeration.
inline constexpr Choice gradient_forms[] = {{"linear", "Linear", "Across the drag."},
                                            {"radial", "Radial", "Around the press."}};

// A shape as it is drawn out; angles in radians.
struct ShapeSize {
    double length;  // from the press to the pointer
    double radius;  // of the brush
    int rays = 0;
    GradientForm form = GradientForm::linear;
};

// Of a point at polar angle `middle` about the press and azimuth `turn` from the line to the pointer: how far
// it lies from the shape, in brush radii.
using ShapeDistance = double (*)(const ShapeSize& size, double middle, double turn);

// Of such a point, wherever it lies: how much of the full effect it has, 0 to 1.
struct GradientTool {
    double (*amount)(const ShapeSize& size, double middle, double turn);
};

// The same point by the ray from the press to the pointer: how far along it, and how far off it.
struct RayPlace {
    double along, off;
};
RayPlace ray_place(double middle, double turn);

struct Shape {
    std::variant<ShapeDistance, GradientTool> work;
    int rays = 0;
    GradientForm form = GradientForm::linear;
    dvec3 from{0, 0, 1}, to{0, 0, 1};  // unit, above the horizon of the layer's frame
};

// The raster with the shape in it, painted at once, so that it does not overlap itself.
std::shared_ptr<const Raster> with_shape(const Raster& before, const Shape& shape, const Brush& brush,
                                         const BrushSymmetry& symmetry);

}  // namespace nacre
