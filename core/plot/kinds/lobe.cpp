// A term over k2 in the plane of incidence, polar.
#include <fmt/core.h>

#include <cmath>
#include <utility>

#include "core/model/polar_angles.h"
#include "core/plot/colour_series.h"
#include "core/plot/pair_plots.h"
#include "core/plot/section_plots.h"

namespace nacre {
namespace {

// Where the mirror images of k1 in the lobes' axes lie in the plane of incidence, as far as they do.
std::vector<double> peak_angles(const Tables& tables, const PlotSettings& settings) {
    const dvec3 forward = polar_direction(90, settings.azimuth);
    std::vector<double> angles = {settings.incidence};
    for (const PlacedLobe& placed : tables.distribution->lobes()) {
        const dvec3 axis = placed.frame[2];
        const double tilt = polar_angle({glm::dot(axis, forward), 0, axis.z});
        angles.push_back(settings.incidence + 2 * std::copysign(tilt, glm::dot(axis, forward)));
    }
    return angles;
}

Plot make(const Tables& tables, const PlotSettings& settings) {
    const TermOf term(tables, incident_direction(settings), settings.term);
    const auto value = [&](double angle) { return term(polar_direction(angle, settings.azimuth)); };
    // Grey only where every sample is, and most are grey in the mirror direction already.
    const bool grey = is_grey(value(settings.incidence)) && is_grey(value(-settings.incidence)) &&
                      is_grey(value(0)) && is_grey(value(85));
    const CurveRange range{.low = -horizon,
                           .high = horizon,
                           .hints = peak_angles(tables, settings),
                           .logarithmic = settings.is_logarithmic()};
    CurvePlot curves = sampled(colour_series(words_of(settings.term), grey), range,
                               [&](double angle, std::span<double> values) {
                                   const dvec3 rho = value(angle);
                                   for (std::size_t c = 0; c < values.size(); ++c)
                                       values[c] = rho[static_cast<int>(c)];
                               });
    curves.x = angle_axis("angle of k2 from the normal, \u03b82", -90, 90);
    curves.y = term_axis(settings.term, highest_of(curves.series), settings.is_logarithmic());
    return {.title = fmt::format("{} in the plane of incidence", words_of(settings.term)),
            .subtitle = incidence_text(settings),
            .contents = LobePlot{.curves = std::move(curves), .incidence = settings.incidence}};
}

}  // namespace

const PlotInfo lobe_plot{
    .label = "Lobe",
    .about =
        "Light reflected within the plane of incidence, for light along k1. Drag in the plot to move k1.",
    .has_term = true,
    .angles = incidence_angles,
    .make = make};

}  // namespace nacre
