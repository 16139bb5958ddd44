// One touch of the brush on a painted layer's raster, in the layer's own frame.
#pragma once

#include <cmath>
#include <glm/mat2x2.hpp>
#include <numbers>

#include "core/image/raster.h"
#include "core/paint/brush.h"
#include "core/paint/coverage.h"

namespace nacre {

struct Dab {
    Brush brush;
    BrushSymmetry symmetry;
    dvec3 at{0, 0, 1};
    dvec3 from{0, 0, 1};          // where the brush was
    const Raster* tip = nullptr;  // a square picture as wide as the brush; white paints
    glm::dmat2 to_tip{1};         // see stamp_from_layer()

    double radius() const { return brush.radius * (std::numbers::pi / 180); }  // radians
};

// Calls visit(SeenTexel, amount) for what the round brush covers.
template <class Visit>
void visit_covered(const Raster& raster, const Dab& dab, const Visit& visit) {
    const double chord = 2 * std::sin(0.5 * std::min(dab.radius(), std::numbers::pi));
    visit_images(raster.width, dab.symmetry, dab.at, dab.radius(), [&](const SeenTexel& texel) {
        const dvec3 off = texel.original - dab.at;
        if (glm::dot(off, off) >= chord * chord) return;
        visit(texel, dab.brush.flow *
                         brush_falloff(dab.brush, angle_between(texel.original, dab.at) / dab.radius()));
    });
}

// Adds what the round brush covers.
void cover(const Raster& raster, const Dab& dab, Coverage& coverage);

}  // namespace nacre
