// Quick shapes: drawn whole between the point of the press and the pointer.
#pragma once

#include <memory>

#include "core/paint/brush.h"
#include "core/paint/stroke.h"

namespace nacre {

enum class ShapeKind {
    line,  // from the press to the pointer
    ring,  // about the press, through the pointer
    star   // rays from the press, one of them to the pointer, that taper to their ends
};

struct Shape {
    ShapeKind kind = ShapeKind::line;
    int rays = 5;
    dvec3 from{0, 0, 1}, to{0, 0, 1};  // unit, in the layer's frame
};

// The raster with the shape in it, as broad as the brush and painted at once: nothing overlaps itself.
std::shared_ptr<const Raster> with_shape(const Raster& before, const Shape& shape, const Brush& brush,
                                         const BrushSymmetry& symmetry);

}  // namespace nacre
