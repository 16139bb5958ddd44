// F over the angle between a facet's normal and the light.
#include <algorithm>
#include <utility>

#include "core/model/polar_angles.h"
#include "core/plot/colour_series.h"
#include "core/plot/section_plots.h"

namespace nacre {
namespace {

Plot make(const Tables& tables, const PlotSettings& settings) {
    const Shading<double>& shading = tables.shading;
    const bool grey = is_grey(shading.fresnel(1)) && is_grey(shading.fresnel(0.3));
    const CurveRange range{.low = 0, .high = 90, .hints = {}, .logarithmic = settings.is_logarithmic()};
    CurvePlot plot = sampled(colour_series("F", grey), range, [&](double angle, std::span<double> values) {
        const double cosine = std::max(polar_direction(angle, 0).z, 0.0);
        const dvec3 f = shading.fresnel(cosine);
        for (std::size_t c = 0; c < values.size(); ++c) values[c] = f[static_cast<int>(c)];
    });
    plot.x = angle_axis("angle between k1 and h, \u03b8d", 0, 90);
    plot.y = value_axis("F", "", highest_of(plot.series), settings.is_logarithmic(), 1);
    return {.title = "Fresnel reflectance F of a facet", .subtitle = "", .contents = std::move(plot)};
}

}  // namespace

const PlotInfo fresnel_plot{.label = "Fresnel F",
                            .about = "How much light one facet reflects, over the angle of incidence.",
                            .make = make};

}  // namespace nacre
