// P over the angle from the normal.
#include <algorithm>
#include <utility>

#include "core/plot/section_plots.h"

namespace nacre {
namespace {

Plot make(const Tables& tables, const PlotSettings& settings) {
    const Shading<double>& shading = tables.shading;
    const CurveRange range{.low = 0, .high = 90, .hints = {90}, .logarithmic = settings.is_logarithmic()};
    CurvePlot plot = along_azimuths(tables, "P", range, [&](dvec3 k) {
        k.z = std::max(k.z, 0.0);
        return shading.masking(shading.direction(k));
    });
    plot.x = angle_axis("angle of k from the normal, \u03b8", 0, 90);
    plot.y = value_axis("P", "", highest_of(plot.series), settings.is_logarithmic(), 1);
    return {.title = "Masking P(k) = N cos\u03b8 / g(k)",
            .subtitle = shading.kinds.clamp ? "at most 1" : "not clamped",
            .contents = std::move(plot)};
}

}  // namespace

const PlotInfo masking_plot{
    .label = "Masking P",
    .about =
        "The share of the facets facing a direction that is visible from it, P(k) = (k.n) N / g(k) (eq. 25). "
        "Where it falls the surface shadows itself: the rim grows darker.",
    .make = make};

}  // namespace nacre
