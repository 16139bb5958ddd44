// Designs and settings for tests of plots.
#pragma once

#include "core/bake/bake.h"
#include "core/plot/plot.h"
#include "tests/core/designs.h"

namespace nacre::test {

inline std::shared_ptr<const Tables> baked(const Design& design) {
    return bake(design, {.quality = Quality::draft, .albedo = true});
}

inline Design two_sided() {
    return with_layer(design_of(GaussianLobe{0.1, 0.4}, 20, 0), GaussianLobe{0.1, 0.4}, 1, 20, 180);
}

inline Design coloured(Design design) {
    design.fresnel = SchlickFresnel{{0.9, 0.5, 0.2}};
    design.diffuse = CoupledDiffuse{{0.1, 0.3, 0.6}};
    return design;
}

inline PlotSettings settings_of(PlotKind kind, Term term = Term::total) {
    PlotSettings settings;
    settings.kind = kind;
    settings.term = term;
    return settings;
}

inline CurvePlot curves_of(const Tables& tables, const PlotSettings& settings) {
    const Plot plot = *make_plot(tables, settings);
    if (const auto* lobe = std::get_if<LobePlot>(&plot.contents)) return lobe->curves;
    return std::get<CurvePlot>(plot.contents);
}

}  // namespace nacre::test
