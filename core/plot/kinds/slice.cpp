// A term over the half vector's and the difference angle.
#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "core/model/polar_angles.h"
#include "core/plot/pair_plots.h"

namespace nacre {
namespace {

// Cosine: a correlated masking grows like 1/c where both directions graze, and would leave no colour for the
// rest.
constexpr double grazing = 0.1;

constexpr PlotAngle angles[] = {
    {.member = &PlotSettings::azimuth,
     .name = "azimuth",
     .label = "\u03c6 of h",
     .low = -180,
     .high = 180,
     .about = "Azimuth of the half vector: toward which it is tilted from the normal."},
    {.member = &PlotSettings::turn,
     .name = "turn",
     .label = "\u03c6d",
     .low = -180,
     .high = 180,
     .about = "Azimuth of the light about the half vector: 90 is across its tilt, where light and eye stand "
              "above the horizon at every angle."}};

Plot make(const Tables& tables, const PlotSettings& settings) {
    SlicePlot plot{.x = angle_axis("angle of h from the normal, \u03b8h", 0, 90),
                   .y = angle_axis("angle between k1 and h, \u03b8d", 0, 90),
                   .side = settings.slice_side};
    std::vector<HalfFrame> frames;
    std::vector<dvec3> differences, clear;  // values of pairs that decide how far the colours reach
    for (int i = 0; i < plot.side; ++i) {
        frames.emplace_back(plot.angle(i), settings.azimuth);
        differences.push_back(polar_direction(plot.angle(i), settings.turn));
    }
    plot.values.reserve(static_cast<std::size_t>(plot.side) * static_cast<std::size_t>(plot.side));
    for (const dvec3& d : differences)
        for (const HalfFrame& frame : frames) {
            const ReflectedPair pair = frame.pair(d);
            const bool above = pair.k1.z > 0 && pair.k2.z > 0;
            plot.values.push_back(above ? TermOf(tables, pair.k1, settings.term)(pair.k2) : dvec3(0));
            if (std::min(pair.k1.z, pair.k2.z) > grazing) clear.push_back(plot.values.back());
        }
    double highest = highest_luminance(clear);
    if (highest == 0) highest = highest_luminance(plot.values);
    plot.shade = term_axis(settings.term, highest, settings.is_logarithmic());
    return {.title = fmt::format("{} over \u03b8h (along) and \u03b8d (up)", words_of(settings.term)),
            .subtitle =
                fmt::format("\u03c6h {:.1f}\u00b0, \u03c6d {:.1f}\u00b0", settings.azimuth, settings.turn),
            .contents = std::move(plot)};
}

}  // namespace

const PlotInfo slice_plot{
    .label = "Slice",
    .about =
        "The whole BRDF at a glance, over the angles of the half vector (along) and between light and "
        "half vector (up): highlight at the left, Fresnel above, grazing light at the right, "
        "retro-reflection below (Rusinkiewicz 1998; Burley 2012).",
    .has_term = true,
    .angles = angles,
    .logarithmic = true,
    .make = make};

}  // namespace nacre
