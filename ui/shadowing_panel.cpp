#include "ui/material_panel.h"
#include "ui/widgets.h"

namespace nacre::ui {
namespace {

constexpr const char* model_names[] = {"Uncorrelated", "Correlated by azimuth", "Smith, by height"};
constexpr const char* model_tooltip =
    "Masking: facets hide one another from the light and from the eye. Uncorrelated: the two are "
    "independent. "
    "Correlated: when light and eye are on the same side, what one sees the other sees too. Smith: high "
    "facets "
    "are seen by both more often than low ones.";

}  // namespace

bool shadowing_panel(Shadowing& shadowing, double& mean_cosine_scale) {
    int model = static_cast<int>(shadowing.model);
    bool changed = combo("Masking", model, model_names, model_tooltip);
    if (changed) shadowing.model = static_cast<ShadowingModel>(model);
    if (shadowing.model == ShadowingModel::correlated)
        changed |= slider(
            {.label = "Correlation",
             .low = 1,
             .high = 90,
             .least = limits::correlation_min,
             .most = limits::correlation_max,
             .reset = Shadowing{}.width,
             .format = "%.1f\u00b0",
             .logarithmic = false,
             .tooltip = "How far apart in azimuth light and eye may be and still share what they see."},
            shadowing.width);
    changed |=
        checkbox("Keep energy##Clamp", shadowing.clamp,
                 "Masking never brightens: visibility is held at 1 or below, so no distribution reflects "
                 "more light than it gets. Off: the paper's own form.");
    changed |=
        slider({.label = "Mean cosine",
                .low = 0.5,
                .high = 2,
                .least = limits::mean_cosine_scale_min,
                .most = limits::mean_cosine_scale_max,
                .reset = 1,
                .format = "\u00d7 %.3f",
                .logarithmic = true,
                .tooltip = "Multiplies the mean of (normal . half vector) over the facets, which scales the "
                           "whole highlight. 1 is right for a height field; slanted velvet takes 2 for the "
                           "tops of its fibres."},
               mean_cosine_scale);
    return changed;
}

}  // namespace nacre::ui
