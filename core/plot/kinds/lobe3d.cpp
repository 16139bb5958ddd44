// A term over all k2, as a shape in space.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>

#include "core/model/polar_angles.h"
#include "core/plot/pair_plots.h"

namespace nacre {
namespace {

constexpr int shape_rings = 56, shape_spokes = 72;

// The direction at a point of the stereographic disk, whose rim is the horizon.
dvec3 disk_to_hemisphere(std::complex<double> w) {
    const double r2 = std::norm(w);
    return glm::normalize(dvec3(2 * w.real(), 2 * w.imag(), std::max(1 - r2, 0.0)));
}

// Radii of rings up to `rim`, so dense in the middle that p of that width is drawn by several of them:
// sinh(s t)/sinh(s), s from the first radius.
std::vector<double> ring_radii(double width, double rim) {
    const double first = std::clamp(0.15 * width, 1e-5, 1.0 / shape_rings);
    double low = 1e-6, high = 30;
    for (int i = 0; i < 50; ++i) {
        const double s = 0.5 * (low + high);
        (std::sinh(s / shape_rings) / std::sinh(s) > first ? low : high) = s;
    }
    std::vector<double> radii;
    for (int i = 1; i <= shape_rings; ++i)
        radii.push_back(rim * std::sinh(low * i / shape_rings) / std::sinh(low));
    return radii;
}

// Rings about the mirror direction that end at the horizon: the disk's rings about its middle, carried there
// by the automorphism w -> (w + a)/(1 + conj(a) w) of the disk, which keeps its rim.
std::vector<dvec3> shape_directions(const Tables& tables, const PlotSettings& settings) {
    const dvec3 mirror = polar_direction(settings.incidence, settings.azimuth);
    const std::complex<double> a = std::complex<double>(mirror.x, mirror.y) / (1 + mirror.z);
    const auto& stretch = tables.shading.surface.tables.stretch;
    std::vector<dvec3> k2 = {mirror};
    // As near to the horizon that the last ring is all but there wherever the middle is carried.
    const double rim = 1 - 1e-5 * (1 - std::abs(a));
    for (const double radius : ring_radii(std::min(stretch.x, stretch.y), rim))
        for (int spoke = 0; spoke < shape_spokes; ++spoke) {
            const std::complex<double> w = std::polar(radius, 2 * std::numbers::pi * spoke / shape_spokes);
            k2.push_back(disk_to_hemisphere((w + a) / (1.0 + std::conj(a) * w)));
        }
    return k2;
}

Plot make(const Tables& tables, const PlotSettings& settings) {
    ShapePlot plot{.rings = shape_rings, .spokes = shape_spokes};
    plot.k1 = incident_direction(settings);
    plot.k2 = shape_directions(tables, settings);
    const TermOf term(tables, plot.k1, settings.term);
    plot.values.reserve(plot.k2.size());
    for (const dvec3& k2 : plot.k2) plot.values.push_back(term(k2));
    plot.radius = term_axis(settings.term, highest_luminance(plot.values), settings.is_logarithmic());
    return {.title = fmt::format("{} over all k2", words_of(settings.term)),
            .subtitle = incidence_text(settings),
            .contents = std::move(plot)};
}

}  // namespace

const PlotInfo lobe3d_plot{
    .label = "3-D lobe",
    .about =
        "Light reflected in every direction, for light along k1. Drag to turn it, the wheel zooms, a "
        "double click shows all.",
    .has_term = true,
    .angles = incidence_angles,
    .make = make};

}  // namespace nacre
