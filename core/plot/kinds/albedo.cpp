// R over the angle from the normal.
#include <algorithm>
#include <utility>

#include "core/image/luminance.h"
#include "core/model/polar_angles.h"
#include "core/plot/colour_series.h"
#include "core/plot/section_plots.h"

namespace nacre {
namespace {

// R of the tables at one direction: of the material, and for f0 = 0 and f0 = 1, where tints differ as
// luminance.
struct AlbedoAt {
    dvec3 material;
    double zero, one;
};

AlbedoAt albedo_at(const Tables& tables, dvec3 k) {
    k.z = std::max(k.z, 0.0);
    Shading<double> shading = tables.shading;
    shading.kinds.coat = kind_index<Coat, NoCoat>();  // of the facets in their medium
    AlbedoValues v = read_albedo(shading, k, tables.needs.fresnel_tables);
    if (shading.kinds.retro) {
        const AlbedoValues behind = read_albedo(shading, shading.turned(k), tables.needs.fresnel_tables);
        const double part = 0.5 * shading.surface.retro;
        for (std::size_t i = 0; i < v.size(); ++i) v[i] += part * (behind[i] - v[i]);
    }
    const bool varied = tables.needs.tint == Tint::varied;
    return {.material = shading.direction(k).R,
            .zero = varied ? luminance({v[3], v[4], v[5]}) : v[1],
            .one = varied ? luminance({v[0], v[1], v[2]}) : v[0]};
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

bool is_coloured(const Shading<double>& shading) {
    bool coloured = !is_grey(shading.fresnel(1));
    for (int i = 0; i < shading.layer_count; ++i) coloured = coloured || !is_grey(shading.layers[i].tint);
    return coloured;
}

AlbedoCurves albedo_curves(const Tables& tables, bool several_azimuths) {
    const ShadingKinds& kinds = tables.shading.kinds;
    AlbedoCurves curves;
    curves.grey = several_azimuths || !is_coloured(tables.shading);
    curves.zero = kinds.fresnel_tables() == FresnelTables::linear;
    curves.one = kinds.fresnel_tables() != FresnelTables::none || kinds.tint == Tint::shared;
    return curves;
}

Plot make(const Tables& tables, const PlotSettings& settings) {
    const std::vector<double> azimuths = shown_azimuths(tables.needs.symmetry);
    const bool several = azimuths.size() > 1;
    const AlbedoCurves kinds = albedo_curves(tables, several);
    std::vector<Series> series;
    for (std::size_t i = 0; i < azimuths.size(); ++i)
        kinds.name(series, several ? azimuth_name(azimuths[i]) : "R", several ? azimuth_ink(i) : Ink::plain);
    const CurveRange range{.low = 0, .high = 90, .hints = {0}, .logarithmic = settings.is_logarithmic()};
    CurvePlot plot = sampled(std::move(series), range, [&](double theta, std::span<double> values) {
        for (std::size_t i = 0; i < azimuths.size(); ++i)
            kinds.read(albedo_at(tables, polar_direction(theta, azimuths[i])),
                       values.subspan(i * kinds.count(), kinds.count()));
    });
    plot.x = angle_axis("angle of k from the normal, \u03b8", 0, 90);
    plot.y = value_axis("albedo R", "", highest_of(plot.series), settings.is_logarithmic(), 1);
    const bool shares = several && is_coloured(tables.shading);
    return {.title = "Directional albedo R(k) of the specular term",
            .subtitle = shares ? "the material's R as luminance" : "",
            .contents = std::move(plot)};
}

}  // namespace

const PlotInfo albedo_plot{
    .label = "Albedo R",
    .about =
        "How much of the light from one direction the highlight reflects in all: R(k), the integral of the "
        "specular term (eq. 29). Shown for the material and for facets of f0 = 0 and 1. At 1 no light is "
        "lost.",
    .needs_albedo = true,
    .make = make};

}  // namespace nacre
