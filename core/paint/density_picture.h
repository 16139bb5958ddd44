// p(h) as a picture.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "core/model/facet_distribution.h"
#include "core/paint/hemisphere_view.h"

namespace nacre {

enum class ScaleKind {
    perceptual,  // by lightness, CIE 1976 L*: half way up looks half as bright
    linear,
    logarithmic  // four decades below the peak
};

// How values of p become colours: `peak` is the brightest.
struct DensityScale {
    double peak = 1;  // 1/sr
    ScaleKind kind = ScaleKind::perceptual;

    double position(double p) const;      // in [0, 1]
    double value(double position) const;  // its inverse, for p from peak/10^4 upward
};

// The largest p on a grid over the sphere and at each lobe's axis, 1/sr: what a scale goes up to. A ridge
// between the grid's points may be higher.
double peak_density(const FacetDistribution& p);

struct DensityPicture {
    glm::ivec2 size{0};
    std::vector<std::uint8_t> rgba;  // rows from the top, straight alpha, transparent beside the hemisphere
};

// p under each pixel's middle; `divisor` times fewer pixels each way than the view has.
DensityPicture density_picture(const FacetDistribution& p, const HemisphereView& view,
                               const DensityScale& scale, int divisor);

}  // namespace nacre
