// p(h) as a picture.
#pragma once

#include <cstdint>
#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "core/base/choice.h"
#include "core/image/raster.h"
#include "core/model/facet_distribution.h"
#include "core/paint/hemisphere_view.h"

namespace nacre {

enum class ScaleKind { perceptual, linear, logarithmic, material };

// In the order of the enumeration.
inline constexpr Choice density_scales[] = {
    {"perceptual", "As seen",
     "Brightness by lightness (CIE 1976 L*): halfway up looks half as bright, so that a core and the "
     "glow around it both show."},
    {"linear", "Linear",
     "Brightness in proportion to p: halfway up are half as many facets. A glow around a strong core stays "
     "dark."},
    {"logarithmic", "Logarithmic",
     "Brightness by powers of ten, four below the peak: shows the faintest haze around a core."},
    {"material", "Material",
     "The material's own colours under the main light, as a sphere shows them that is lit and seen from the "
     "same side."}};

// How values of p become colours: `peak` is the brightest.
struct DensityScale {
    double peak = 1;                         // 1/sr
    ScaleKind kind = ScaleKind::perceptual;  // `material` is no scale of p and counts as perceptual

    double position(double p) const;      // in [0, 1]
    double value(double position) const;  // its inverse, for p from peak/10^4 upward
};

// The largest p on a grid over the sphere and at each lobe's axis, 1/sr: what a scale goes up to. A ridge
// between the grid's points may be higher.
double peak_density(const FacetDistribution& p);

struct HemispherePicture {
    glm::ivec2 size{0};
    std::vector<std::uint8_t> rgba;  // rows from the top, straight alpha, transparent beside the hemisphere
};

// Colours of the directions under the middles of a row's pixels, sRGB.
using RowColours = std::function<std::vector<glm::u8vec3>(std::span<const dvec3> directions)>;

// `divisor` times fewer pixels each way than the view has.
HemispherePicture hemisphere_picture(const HemisphereView& view, int divisor, const RowColours& colours);

// p, by a scale of brightness; a null p is 0 all over.
HemispherePicture density_picture(const FacetDistribution* p, const HemisphereView& view,
                                  const DensityScale& scale, int divisor);

// Lays the colour of a veil over what a layer's mask hides, as far as it does.
void veil_what_is_hidden(HemispherePicture& picture, const HemisphereView& view, int divisor,
                         const Raster& mask, const glm::dmat3& layer_frame);

}  // namespace nacre
