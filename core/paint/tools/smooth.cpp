// Toward the mean of the neighbourhood.
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/paint/paint_tool.h"

namespace nacre {
namespace {

// 1 4 6 4 1 over 16, both ways, `step` texels apart, of the texels that hold facets. Its sums pair what a
// mirror swaps.
class Smoother {
  public:
    Smoother(std::vector<float> before, int side, double radius) : values_(std::move(before)), side_(side) {
        step_ = std::max(1, static_cast<int>(std::lround(radius / 10 * side / 2)));
    }

    double operator()(std::size_t index) const {
        const int row = static_cast<int>(index) / side_, column = static_cast<int>(index) % side_;
        const dvec2 sum = 6.0 * across(row, column) +
                          4.0 * (across(row - step_, column) + across(row + step_, column)) +
                          (across(row - 2 * step_, column) + across(row + 2 * step_, column));
        return sum.y > 0 ? sum.x / sum.y : static_cast<double>(values_[index]);
    }

  private:
    // Sum of values and of weights.
    dvec2 across(int row, int column) const {
        return 6.0 * texel(row, column) + 4.0 * (texel(row, column - step_) + texel(row, column + step_)) +
               (texel(row, column - 2 * step_) + texel(row, column + 2 * step_));
    }
    dvec2 texel(int row, int column) const {
        if (row < 0 || column < 0 || row >= side_ || column >= side_) return {0, 0};
        if (!holds_facets(texel_point(side_, row, column))) return {0, 0};
        return {values_[static_cast<std::size_t>(row) * static_cast<std::size_t>(side_) +
                        static_cast<std::size_t>(column)],
                1};
    }

    std::vector<float> values_;
    int side_;
    int step_;
};

void dab(Raster& raster, const Dab& dab, Coverage& scratch) {
    const Smoother smoother(raster.values, raster.width, dab.radius());
    cover(raster, dab, scratch);
    scratch.pull(raster.values, smoother);
}

void icon(const IconPen& pen) {
    pen.disc({0.5f, 0.5f}, 0.11f);
    pen.circle({0.5f, 0.5f}, 0.23f);
    pen.circle({0.5f, 0.5f}, 0.37f);
}

}  // namespace

const PaintToolInfo smooth_tool{.face = {.name = "Smooth",
                                         .key = 'S',
                                         .about = "Softens what is painted.",
                                         .more = "Edges of the highlight blur.",
                                         .icon = icon},
                                .work = DabTool{.dab = dab}};

}  // namespace nacre
