#include "core/plot/section_plots.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/model/luminance.h"
#include "core/model/polar_angles.h"
#include "core/plot/colour_series.h"
#include "core/plot/curve_sampler.h"

namespace nacre {
namespace {

constexpr Ink azimuth_inks[] = {Ink::first, Ink::second, Ink::third, Ink::fourth};
constexpr double below_horizon_noticed = 0.01;  // share of the facets' area that is seen from below

// As few azimuths as show what the symmetry leaves open: from a mirror plane on, where there is one.
std::vector<double> shown_azimuths(const DistributionSymmetry& symmetry) {
    double step = 90;
    switch (symmetry.symmetry) {
        case Symmetry::isotropic:
            return {0};
        case Symmetry::quarter:
            step = 30;
            break;
        case Symmetry::half:
            step = 60;
            break;
        case Symmetry::none:
            break;
    }
    std::vector<double> azimuths;
    for (int i = 0; i < 4; ++i) azimuths.push_back(symmetry.axis + i * step);
    return azimuths;
}

double highest_of(const std::vector<Series>& series) {
    double highest = 0;
    for (const Series& one : series)
        for (const double value : one.values)
            if (std::isfinite(value)) highest = std::max(highest, value);
    return highest;
}

struct Curves {
    std::vector<Series> series;
    CurveRange range;
};

CurvePlot sampled(Curves curves, const CurvesAt& values_at) {
    CurvePlot plot;
    SampledCurves samples = sample_curves(curves.range, curves.series.size(), values_at);
    plot.at = std::move(samples.at);
    for (std::size_t i = 0; i < curves.series.size(); ++i)
        curves.series[i].values = std::move(samples.values[i]);
    plot.series = std::move(curves.series);
    return plot;
}

std::string azimuth_name(double phi) { return fmt::format("\u03c6 {:.4g}\u00b0", phi); }

// One quantity along each of the shown azimuths.
template <class ValueOf>
CurvePlot along_azimuths(const Tables& tables, const std::string& name, CurveRange range,
                         const ValueOf& value_of) {
    const std::vector<double> azimuths = shown_azimuths(tables.plan.symmetry);
    Curves curves{.series = {}, .range = std::move(range)};
    if (azimuths.size() == 1) curves.series = {{.name = name}};
    for (std::size_t i = 0; azimuths.size() > 1 && i < azimuths.size(); ++i)
        curves.series.push_back({.name = azimuth_name(azimuths[i]), .ink = azimuth_inks[i]});
    return sampled(std::move(curves), [&](double theta, std::span<double> values) {
        for (std::size_t i = 0; i < azimuths.size(); ++i)
            values[i] = value_of(polar_direction(theta, azimuths[i]));
    });
}

// What the tables tell of R at one direction: of the material, and for f0 = 0 and f0 = 1.
struct AlbedoAt {
    dvec3 material;
    double zero, one;
};

AlbedoAt albedo_at(const Tables& tables, dvec3 k) {
    k.z = std::max(k.z, 0.0);
    const Values<4> values = read_albedo(tables.shading, k, tables.plan.fresnel_tables);
    return {.material = tables.shading.direction(k).R, .zero = values[1], .one = values[0]};
}

// The curves of one azimuth: the material's R as a colour or as its luminance, then f0 = 0 and f0 = 1 where
// they differ from it.
struct AlbedoCurves {
    bool grey = true, zero = false, one = false;

    std::size_t count() const { return (grey ? 1u : 3u) + (zero ? 1u : 0u) + (one ? 1u : 0u); }

    void read(const AlbedoAt& at, std::span<double> values) const {
        std::size_t i = 0;
        if (grey) values[i++] = luminance(at.material);
        for (int c = 0; !grey && c < 3; ++c) values[i++] = at.material[c];
        if (zero) values[i++] = at.zero;
        if (one) values[i++] = at.one;
    }

    void name(std::vector<Series>& series, const std::string& of, Ink ink) const {
        for (Series& one_of : colour_series(of, grey)) {
            if (grey) one_of.ink = ink;
            series.push_back(std::move(one_of));
        }
        const std::string before = of == "R" ? "R, " : of + ", ";
        if (zero) series.push_back({.name = before + "f0 = 0", .ink = ink, .dash = Dash::dotted});
        if (one) series.push_back({.name = before + "f0 = 1", .ink = ink, .dash = Dash::dashed});
    }
};

AlbedoCurves albedo_curves(const Tables& tables, bool several_azimuths) {
    const ShadingKinds& kinds = tables.shading.kinds;
    AlbedoCurves curves;
    curves.grey = several_azimuths || is_grey(tables.shading.fresnel(1)) ||
                  kinds.fresnel_tables() == FresnelTables::none;
    curves.zero = kinds.fresnel_tables() == FresnelTables::linear;
    curves.one = kinds.fresnel_tables() != FresnelTables::none;
    return curves;
}

}  // namespace

Plot albedo_plot(const Tables& tables, const PlotSettings& settings) {
    const std::vector<double> azimuths = shown_azimuths(tables.plan.symmetry);
    const bool several = azimuths.size() > 1;
    const AlbedoCurves kinds = albedo_curves(tables, several);
    Curves curves{.series = {},
                  .range = {.low = 0, .high = 90, .hints = {0}, .logarithmic = settings.is_logarithmic()}};
    for (std::size_t i = 0; i < azimuths.size(); ++i)
        kinds.name(curves.series, several ? azimuth_name(azimuths[i]) : "R",
                   several ? azimuth_inks[i] : Ink::plain);
    CurvePlot plot = sampled(std::move(curves), [&](double theta, std::span<double> values) {
        for (std::size_t i = 0; i < azimuths.size(); ++i)
            kinds.read(albedo_at(tables, polar_direction(theta, azimuths[i])),
                       values.subspan(i * kinds.count(), kinds.count()));
    });
    plot.x = angle_axis("angle of k from the normal, \u03b8", 0, 90);
    plot.y = value_axis("albedo R", "", highest_of(plot.series), settings.is_logarithmic(), 1);
    const bool shares = several && !is_grey(tables.shading.fresnel(1));
    return {.title = "Directional albedo R(k) of the specular term",
            .subtitle = shares ? "the material's R as luminance" : "",
            .contents = std::move(plot)};
}

Plot masking_plot(const Tables& tables, const PlotSettings& settings) {
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

Plot density_plot(const Tables& tables, const PlotSettings& settings) {
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

Plot fresnel_plot(const Tables& tables, const PlotSettings& settings) {
    const Shading<double>& shading = tables.shading;
    const bool grey = is_grey(shading.fresnel(1)) && is_grey(shading.fresnel(0.3));
    CurvePlot plot =
        sampled({.series = colour_series("F", grey),
                 .range = {.low = 0, .high = 90, .hints = {}, .logarithmic = settings.is_logarithmic()}},
                [&](double angle, std::span<double> values) {
                    const double cosine = std::max(polar_direction(angle, 0).z, 0.0);
                    const dvec3 f = shading.fresnel(cosine);
                    for (std::size_t c = 0; c < values.size(); ++c) values[c] = f[static_cast<int>(c)];
                });
    plot.x = angle_axis("angle between k1 and h, \u03b8d", 0, 90);
    plot.y = value_axis("F", "", highest_of(plot.series), settings.is_logarithmic(), 1);
    return {.title = "Fresnel reflectance F of a facet", .subtitle = "", .contents = std::move(plot)};
}

}  // namespace nacre
