#include "core/plot/pair_plots.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/image/luminance.h"
#include "core/model/polar_angles.h"

namespace nacre {

dvec3 incident_direction(const PlotSettings& settings) {
    return polar_direction(settings.incidence, settings.azimuth + 180);
}

std::string incidence_text(const PlotSettings& settings) {
    return fmt::format("k1 at \u03b8 {:.1f}\u00b0, mirrored toward \u03c6 {:.1f}\u00b0", settings.incidence,
                       settings.azimuth);
}

HalfFrame::HalfFrame(double theta_h, double phi_h)
    : along(polar_direction(theta_h + 90, phi_h)),
      across(polar_direction(90, phi_h + 90)),
      h(polar_direction(theta_h, phi_h)) {}

ReflectedPair HalfFrame::pair(const dvec3& difference) const {
    const dvec3 side = along * difference.x + across * difference.y;
    return {h * difference.z + side, h * difference.z - side};
}

std::string words_of(Term term) {
    switch (term) {
        case Term::total:
            return "BRDF \u03c1";
        case Term::specular:
            return "Specular \u03c1";
        case Term::multibounce:
            return "Bounces \u03c1";
        case Term::retro:
            return "Retro-reflected \u03c1";
        case Term::diffuse:
            return "Diffuse \u03c1";
        case Term::coat:
            return "Coat \u03c1";
        case Term::fresnel:
            return "F(k\u00b7h)";
        case Term::density:
            return "p(h)";
        case Term::masking1:
            return "P(k1)";
        case Term::masking2:
            return "P(k2)";
        case Term::inverse_areas:
            break;
    }
    return "1/(g(k1) g(k2))";
}

Axis term_axis(Term term, double highest, bool logarithmic) {
    const bool fraction = term == Term::fresnel || term == Term::masking1 || term == Term::masking2;
    const bool plain = fraction || term == Term::inverse_areas;
    return value_axis(words_of(term), plain ? "" : "1/sr", highest, logarithmic, fraction ? 1 : 0);
}

double highest_luminance(const std::vector<dvec3>& values) {
    double highest = 0;
    for (const dvec3& value : values)
        if (const double l = luminance(value); std::isfinite(l)) highest = std::max(highest, l);
    return highest;
}

}  // namespace nacre
