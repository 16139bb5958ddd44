#include "core/model/spectral/spectral_colour.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vector_relational.hpp>

namespace nacre {
namespace {

using glm::dvec3;

#include "core/model/spectral/cie_tables.inc"

// (position, fraction) of a wavelength in a table of even steps.
template <class Values>
auto interpolated(const Values& values, double wavelength, double step) {
    const double place = (wavelength - spectrum_begin) / step;
    const std::size_t i = std::min(static_cast<std::size_t>(place), values.size() - 2);
    const double t = place - static_cast<double>(i);
    return values[i] * (1 - t) + values[i + 1] * t;
}

// x, y, z of a full reflectance's light.
dvec3 stimulus(double wavelength) {
    return interpolated(observer, wavelength, 1) * interpolated(daylight, wavelength, 5);
}

// Rec. ITU-R BT.709-6, item 1.3, each as x, y, z = 1 - x - y.
const glm::dmat3 primaries{{0.64, 0.33, 0.03}, {0.30, 0.60, 0.10}, {0.15, 0.06, 0.79}};

// From XYZ to the primaries, each scaled so that `white` is (1, 1, 1).
glm::dmat3 to_rgb(dvec3 white) {
    const dvec3 scale = glm::inverse(primaries) * white;
    return glm::inverse(glm::dmat3(primaries[0] * scale.x, primaries[1] * scale.y, primaries[2] * scale.z));
}

}  // namespace

std::vector<SpectralNode> spectral_nodes(int steps) {
    const int count = static_cast<int>(spectrum_end - spectrum_begin) * steps;
    std::vector<SpectralNode> nodes;
    dvec3 white{0};
    for (int i = 0; i <= count; ++i) {
        const double wavelength = spectrum_begin + static_cast<double>(i) / steps;
        const dvec3 xyz = stimulus(wavelength) * (i == 0 || i == count ? 0.5 : 1.0);
        nodes.push_back({wavelength, xyz});
        white += xyz;
    }
    const glm::dmat3 matrix = to_rgb(white);
    for (SpectralNode& node : nodes) node.weight = matrix * node.weight;
    return nodes;
}

GamutColour clip_to_gamut(dvec3 colour) {
    const dvec3 inside = glm::clamp(colour, 0.0, 1.0);
    const dvec3 outside = glm::abs(colour - inside);
    return {inside, std::max({outside.x, outside.y, outside.z})};
}

}  // namespace nacre
