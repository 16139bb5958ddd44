#include "core/plot/pair_plots.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>

#include "core/bake/brdf.h"
#include "core/image/luminance.h"
#include "core/model/polar_angles.h"
#include "core/plot/colour_series.h"
#include "core/plot/curve_sampler.h"

namespace nacre {
namespace {

constexpr double horizon = 90 - 1e-3;  // degrees: as near to it as a direction above it needs to be
// Cosine: a correlated masking grows like 1/c where both directions graze, and would leave no colour for the
// rest of a slice.
constexpr double grazing = 0.1;
constexpr int shape_rings = 56, shape_spokes = 72;

double highest_luminance(const std::vector<dvec3>& values) {
    double highest = 0;
    for (const dvec3& value : values)
        if (const double l = luminance(value); std::isfinite(l)) highest = std::max(highest, l);
    return highest;
}

// A term's name in a title.
std::string words_of(Term term) {
    switch (term) {
        case Term::total:
            return "BRDF \u03c1";
        case Term::specular:
            return "Specular \u03c1";
        case Term::diffuse:
            return "Diffuse \u03c1";
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

// The term for one k1, read from the tables once, and any k2.
class TermOf {
  public:
    TermOf(const Tables& tables, dvec3 k1, Term term)
        : shading_(tables.shading), a_(shading_.direction(k1)), term_(term) {}

    dvec3 operator()(dvec3 k2) const { return brdf_term(shading_, a_, shading_.direction(k2), term_); }

  private:
    const Shading<double>& shading_;
    Shading<double>::Direction a_;
    Term term_;
};

std::string incidence_text(const PlotSettings& settings) {
    return fmt::format("k1 at \u03b8 {:.1f}\u00b0, mirrored toward \u03c6 {:.1f}\u00b0", settings.incidence,
                       settings.azimuth);
}

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

// The frame of a half vector: z = h, x along rising theta.
struct HalfFrame {
    dvec3 along, across, h;

    HalfFrame(double theta, double phi)
        : along(polar_direction(theta + 90, phi)),
          across(polar_direction(90, phi + 90)),
          h(polar_direction(theta, phi)) {}

    ReflectedPair pair(const dvec3& d) const {
        const dvec3 side = along * d.x + across * d.y;
        return {h * d.z + side, h * d.z - side};
    }
};

}  // namespace

dvec3 incident_direction(const PlotSettings& settings) {
    return polar_direction(settings.incidence, settings.azimuth + 180);
}

ReflectedPair half_difference_pair(double theta_h, double phi_h, double theta_d, double phi_d) {
    return HalfFrame(theta_h, phi_h).pair(polar_direction(theta_d, phi_d));
}

Plot lobe_plot(const Tables& tables, const PlotSettings& settings) {
    const TermOf term(tables, incident_direction(settings), settings.term);
    const auto value = [&](double angle) { return term(polar_direction(angle, settings.azimuth)); };
    // Grey only where every sample is, and most are grey in the mirror direction already.
    const bool grey = is_grey(value(settings.incidence)) && is_grey(value(-settings.incidence)) &&
                      is_grey(value(0)) && is_grey(value(85));
    std::vector<Series> series = colour_series(words_of(settings.term), grey);
    SampledCurves samples = sample_curves({.low = -horizon,
                                           .high = horizon,
                                           .hints = peak_angles(tables, settings),
                                           .logarithmic = settings.is_logarithmic()},
                                          series.size(), [&](double angle, std::span<double> values) {
                                              const dvec3 rho = value(angle);
                                              for (std::size_t c = 0; c < values.size(); ++c)
                                                  values[c] = rho[static_cast<int>(c)];
                                          });
    double highest = 0;
    for (std::size_t i = 0; i < series.size(); ++i) {
        for (const double v : samples.values[i])
            if (std::isfinite(v)) highest = std::max(highest, v);
        series[i].values = std::move(samples.values[i]);
    }
    CurvePlot curves{.x = angle_axis("angle of k2 from the normal, \u03b82", -90, 90),
                     .y = term_axis(settings.term, highest, settings.is_logarithmic()),
                     .at = std::move(samples.at),
                     .series = std::move(series)};
    return {.title = fmt::format("{} in the plane of incidence", words_of(settings.term)),
            .subtitle = incidence_text(settings),
            .contents = LobePlot{.curves = std::move(curves), .incidence = settings.incidence}};
}

Plot shape_plot(const Tables& tables, const PlotSettings& settings) {
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

double SlicePlot::angle(int index) const { return std::min(index * 90.0 / (side - 1), horizon); }

Plot slice_plot(const Tables& tables, const PlotSettings& settings) {
    const Shading<double>& shading = tables.shading;
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
            plot.values.push_back(above ? brdf_term(shading, shading.direction(pair.k1),
                                                    shading.direction(pair.k2), settings.term)
                                        : dvec3(0));
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

}  // namespace nacre
