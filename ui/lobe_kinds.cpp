#include "ui/lobe_kinds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace nacre::ui {
namespace {

constexpr std::array<const char*, std::variant_size_v<Lobe>> names = {
    "Gaussian", "Inverse Gaussian", "GGX", "Beckmann", "Uniform", "Curve", "Painted"};

constexpr std::array<const char*, std::variant_size_v<Lobe>> explanations = {
    "Facets cluster around the normal; the highlight of most polished and brushed surfaces. An infinite "
    "width makes a cylinder, as threads or grooves do.\n"
    "p ~ exp(\u2212tan\u00b2\u03b8 (cos\u00b2\u03c6/\u03c3x\u00b2 + sin\u00b2\u03c6/\u03c3y\u00b2)) "
    "(Ashikhmin 2000, eq. 34)",
    "Velvet: facets stand upright like fibres, dark when seen from above, glowing at the rim.\n"
    "p ~ exp(\u2212cot\u00b2\u03b8/\u03c3\u00b2) (Ashikhmin 2000, eq. 35)",
    "A sharp core with a long haze around it; today's common choice for metals.\n"
    "p ~ 1/(x\u00b2/\u03b1x\u00b2 + y\u00b2/\u03b1y\u00b2 + z\u00b2)\u00b2 of the facet normal "
    "(x, y, z) (Walter 2007, eq. 33; Heitz 2014, eq. 85)",
    "Like the Gaussian, with the theory of rough random surfaces behind it.\n"
    "p ~ exp(\u2212tan\u00b2\u03b8 (cos\u00b2\u03c6/\u03b1x\u00b2 + "
    "sin\u00b2\u03c6/\u03b1y\u00b2))/cos\u2074\u03b8 (Walter 2007, eq. 25)",
    "Facets look everywhere equally: matt, like pressed powder.\n"
    "p = 1/(2\u03c0) over the hemisphere, 1/(4\u03c0) over the sphere",
    "p as a curve over the angle from the normal: a core with its haze, halos, a flat top.\n"
    "p ~ the curve at \u03b8, straight lines between its points",
    "p as a picture of the hemisphere seen from above.\n"
    "p ~ the picture's brightness at (x, y)/\u221a(1 + z) of the facet normal (x, y, z)"};

constexpr int painted_size = 256;  // pixels a side of a new painted layer
constexpr double dab_width = 0.2;  // of its first dab, as the slope of a Gaussian

// Slopes at which the lobe has fallen to 1/e, where it has such a thing.
std::pair<double, double> widths(const Lobe& lobe) {
    if (const auto* gaussian = std::get_if<GaussianLobe>(&lobe))
        return {gaussian->sigma_x, gaussian->sigma_y};
    if (const auto* ggx = std::get_if<GgxLobe>(&lobe)) return {ggx->alpha_x, ggx->alpha_y};
    if (const auto* beckmann = std::get_if<BeckmannLobe>(&lobe))
        return {beckmann->alpha_x, beckmann->alpha_y};
    if (const auto* velvet = std::get_if<InverseGaussianLobe>(&lobe)) return {velvet->sigma, velvet->sigma};
    return {dab_width, dab_width};
}

double finite(double width) { return std::isinf(width) ? 1 : width; }

// A round dab in the middle of the equal-area disk, so that a new painted layer is a valid design.
PaintedLobe dab(double width) {
    auto raster = std::make_shared<Raster>();
    raster->width = raster->height = painted_size;
    raster->values.reserve(static_cast<std::size_t>(painted_size) * painted_size);
    for (int row = 0; row < painted_size; ++row)
        for (int column = 0; column < painted_size; ++column) {
            const double x = 2 * (column + 0.5) / painted_size - 1;
            const double y = 2 * (row + 0.5) / painted_size - 1;
            const double squared = x * x + y * y;  // of the disk's radius: 1 - cos theta
            const double cosine = 1 - squared;
            const double tangent2 = cosine > 0 ? 1 / (cosine * cosine) - 1 : HUGE_VAL;
            raster->values.push_back(static_cast<float>(std::exp(-tangent2 / (width * width))));
        }
    return {.image = {.file = {}, .raster = std::move(raster)}};
}

// Eq. 34 along one azimuth, at even angles out to where it has faded.
CurveLobe sampled_gaussian(double width) {
    constexpr int count = 7;
    constexpr double degree = 3.14159265358979323846 / 180;
    const double end = std::min(90.0, std::atan(2.2 * width) / degree);
    CurveLobe curve;
    curve.points.clear();
    for (int i = 0; i < count; ++i) {
        const double theta = std::round(end * i / (count - 1) * 100) / 100;
        const double slope = std::tan(theta * degree) / width;
        const double value = i == count - 1 ? 0 : std::exp(-slope * slope);
        curve.points.emplace_back(theta, std::round(value * 1000) / 1000);
    }
    return curve;
}

}  // namespace

std::span<const char* const> lobe_names() { return names; }

const char* lobe_explanation(std::size_t kind) { return explanations.at(kind); }

Lobe default_lobe(std::size_t kind) { return converted_lobe(GaussianLobe{}, kind); }

Lobe converted_lobe(const Lobe& lobe, std::size_t kind) {
    if (lobe.index() == kind) return lobe;
    const auto [x, y] = widths(lobe);
    const double narrow = std::clamp(std::min(finite(x), finite(y)), 1e-2, 2.0);
    switch (kind) {
        case 0:
            return GaussianLobe{x, y};
        case 1:
            return InverseGaussianLobe{std::max(finite(x), finite(y))};
        case 2:
            return GgxLobe{finite(x), finite(y)};
        case 3:
            return BeckmannLobe{finite(x), finite(y)};
        case 4:
            return UniformLobe{};
        case 5:
            return sampled_gaussian(narrow);
        default:
            return dab(narrow);
    }
}

const char* layer_title(const Layer& layer) {
    return layer.name.empty() ? names.at(layer.lobe.index()) : layer.name.c_str();
}

}  // namespace nacre::ui
