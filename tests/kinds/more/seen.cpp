// p(h) cos(theta): what of the facets is seen from above.
#include <utility>

#include "core/plot/section_plots.h"

namespace nacre {
namespace {

Plot make(const Tables& tables, const PlotSettings& settings) {
    const CurveRange range{.low = 0, .high = 90, .hints = {0}, .logarithmic = settings.is_logarithmic()};
    CurvePlot plot =
        along_azimuths(tables, "p cos", range, [&](dvec3 h) { return tables.shading.density(h) * h.z; });
    plot.x = angle_axis("angle of h from the normal, \u03b8", 0, 90);
    plot.y = value_axis("p(h) cos \u03b8", "1/sr", highest_of(plot.series), settings.is_logarithmic());
    return {.title = "Seen from above", .subtitle = "", .contents = std::move(plot)};
}

}  // namespace

const PlotInfo seen_plot{.label = "Seen", .about = "Facets as they are seen from above.", .make = make};

}  // namespace nacre
