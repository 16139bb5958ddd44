// p over the angle of the facet's normal.
#include <utility>

#include "core/model/polar_angles.h"
#include "core/plot/section_plots.h"

namespace nacre {
namespace {

constexpr double below_horizon_noticed = 0.01;  // share of the facets' area that is seen from below

Plot make(const Tables& tables, const PlotSettings& settings) {
    const bool below = tables.distribution->projected_area({0, 0, -1}) > below_horizon_noticed;
    CurveRange range{
        .low = 0, .high = below ? 180.0 : 90.0, .hints = {0}, .logarithmic = settings.is_logarithmic()};
    for (const PlacedLobe& placed : tables.distribution->lobes())
        range.hints.push_back(polar_angle(placed.frame[2]));
    const Shading<double>& shading = tables.shading;
    CurvePlot plot = along_azimuths(tables, "p", range, [&](dvec3 h) { return shading.density(h); });
    plot.x = angle_axis("angle of h from the normal, \u03b8", 0, range.high);
    plot.y = value_axis("p(h)", "1/sr", highest_of(plot.series), settings.is_logarithmic());
    return {.title = "Density of facet normals p(h)",
            .subtitle = "per steradian, integral 1 over the sphere",
            .contents = std::move(plot)};
}

}  // namespace

const PlotInfo density_plot{.label = "Density p",
                            .about = "How many facets face each way, p(h): the form of the highlight itself.",
                            .make = make};

}  // namespace nacre
