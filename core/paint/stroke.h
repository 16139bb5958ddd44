// A stroke of the brush: dabs at even distances along the way that the hand takes.
#pragma once

#include <memory>

#include "core/paint/dab.h"

namespace nacre {

struct StrokeStyle {
    PaintTool tool = PaintTool::paint;
    Brush brush;
    BrushSymmetry symmetry;
    std::shared_ptr<const Raster> tip;  // of a stamp
};

// Directions are unit vectors in the layer's frame; those below its horizon count as the rim.
class Stroke {
  public:
    // The first dab is where the stroke begins; a smear begins with the first way.
    Stroke(const Raster& before, StrokeStyle style, dvec3 at);

    // Goes there by the great circle. Dabs stand a fifth of the radius apart however the way is parted:
    // parting a great circle moves them by rounding alone. A stamp is set once and follows no way.
    void move_to(dvec3 to);

    // The layer's raster with the stroke so far. The same pointer for as long as nothing is added.
    std::shared_ptr<const Raster> raster();

  private:
    void dab(dvec3 at, dvec3 from);

    Raster working_;
    StrokeStyle style_;
    Coverage scratch_;
    dvec3 at_;  // end of the way so far
    dvec3 last_dab_;
    double to_next_ = 0;  // way until the next dab, radians
    std::shared_ptr<const Raster> published_;
};

}  // namespace nacre
