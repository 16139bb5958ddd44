// What is painted from a press to its release: dabs at even distances along the path of the hand, a shape, or
// an area.
#pragma once

#include <memory>
#include <vector>

#include "core/paint/paint_tool.h"

namespace nacre {

inline constexpr int usual_rays = 5;
inline constexpr double usual_tolerance = 0.1;

struct StrokeStyle {
    PaintTool tool = PaintTool::paint;
    Brush brush;
    BrushSymmetry symmetry;
    std::shared_ptr<const Raster> tip;  // of a tool that needs a picture
    glm::dmat2 to_tip{1};               // see stamp_from_layer()
    int rays = usual_rays;
    GradientForm form = GradientForm::linear;
    double tolerance = usual_tolerance;                // between values that are filled alike
    std::shared_ptr<const TexelShares> selected = {};  // that the whole stroke keeps to; null: all
};

// Directions are unit vectors in the layer's frame; those below its horizon count as the rim.
class Stroke {
  public:
    Stroke(const Raster& before, StrokeStyle style, dvec3 at, const Touch& touch = {});

    // Continues there along the great circle. Dabs are as far apart as the brush's spacing says, however the
    // path is split: splitting a great circle moves them by rounding alone. A shape goes straight from the
    // beginning to here. The touch changes evenly on the way.
    void move_to(dvec3 to, const Touch& touch = {});

    // The layer's raster with the stroke so far. The same pointer for as long as nothing is added.
    std::shared_ptr<const Raster> raster();

  private:
    void dab(dvec3 at, dvec3 from, const Touch& touch);
    void cover_area(const AreaTool& tool);
    double share(std::size_t texel) const;
    std::shared_ptr<const Raster> stroked() const;
    void dabs_to(dvec3 to, const Touch& touch);

    Raster working_;             // a shape leaves it as it was
    std::vector<float> before_;  // values, where opacity or selection mixes them in
    StrokeStyle style_;
    Coverage scratch_;
    dvec3 begin_;
    dvec3 at_;     // end of the path so far
    Touch touch_;  // there
    dvec3 last_dab_;
    double to_next_ = 0;  // distance to the next dab, radians
    std::shared_ptr<const Raster> published_;
};

// All that is selected, painted at once as the brush combines by value and opacity.
std::shared_ptr<const Raster> painted_over(const Raster& before, const TexelShares& selected,
                                           const Brush& brush);

}  // namespace nacre
