// One touch of the brush on a painted layer's raster, in the layer's own frame.
#pragma once

#include "core/image/raster.h"
#include "core/paint/brush.h"
#include "core/paint/coverage.h"

namespace nacre {

enum class PaintTool {
    paint,   // toward 1
    erase,   // toward 0
    smooth,  // toward the neighbourhood's mean
    smear,   // toward what lay where the brush came from
    stamp    // paint through a picture
};

struct Dab {
    PaintTool tool = PaintTool::paint;
    Brush brush;
    BrushSymmetry symmetry;
    dvec3 at{0, 0, 1};
    dvec3 from{0, 0, 1};          // smear: where the brush was
    const Raster* tip = nullptr;  // stamp: a square picture, white paints; as broad as the brush
};

// Full paint is 1, and values stay in [0, 1]. What falls below a part in 10^4 under the eraser is 0. Copies
// of a symmetric dab that overlap count once, the strongest: a mirrored dab is symmetric to the bit where the
// raster was and its side is a power of two; for turned ones rounding remains, and a smear's copies are
// averaged where they meet. `scratch` is of the raster's side, and clear before and after.
void apply_dab(Raster& raster, const Dab& dab, Coverage& scratch);

}  // namespace nacre
