#include "ui/material_panel.h"
#include "ui/widgets.h"

namespace nacre::ui {
namespace {

constexpr const char* model_names[] = {"Uncorrelated", "Correlated by azimuth", "Smith, by height"};
constexpr const char* model_tooltip =
    "Masking: facets hide one another from the light and from the eye, which darkens grazing views. "
    "With P(k) = N (k\u00b7n)/g(k) (eq. 25): uncorrelated, the two are independent, P1 P2. Correlated: when "
    "light and eye are on the same side, what one sees the other sees too, (1 \u2212 t) P1 P2 + t min(P1, "
    "P2) (eq. 14). "
    "Smith: high facets are seen by both more often than low ones, P1 P2/(P1 + P2 \u2212 P1 P2) (Heitz 2014, "
    "eq. 99).";

}  // namespace

bool shadowing_panel(Shadowing& shadowing, double& mean_cosine_scale) {
    int model = static_cast<int>(shadowing.model);
    bool changed = combo("Masking", model, model_names, model_tooltip);
    if (changed) shadowing.model = static_cast<ShadowingModel>(model);
    if (shadowing.model == ShadowingModel::correlated)
        changed |= slider({.label = "Correlation",
                           .low = 1,
                           .high = 90,
                           .least = limits::correlation_min,
                           .most = limits::correlation_max,
                           .reset = Shadowing{}.width,
                           .format = "%.1f\u00b0",
                           .logarithmic = false,
                           .tooltip = "How far apart in azimuth light and eye may be and still share what "
                                      "they see: t = exp(\u2212\u03c6\u00b2/"
                                      "(2 width\u00b2)). Wider brightens what is lit from behind the eye."},
                          shadowing.width);
    changed |= checkbox(
        "Keep energy##Clamp", shadowing.clamp,
        "Masking never brightens: P = min(1, N (k\u00b7n)/g(k)), so no distribution reflects "
        "more light than it gets. A p whose mean leans is dimmer for it on one side. Off: the paper's own "
        "form, P = N (k\u00b7n)/g(k) (eq. 25).");
    changed |= slider(
        {.label = "Mean cosine",
         .low = 0.5,
         .high = 2,
         .least = limits::mean_cosine_scale_min,
         .most = limits::mean_cosine_scale_max,
         .reset = 1,
         .format = "\u00d7 %.3f",
         .logarithmic = true,
         .tooltip = "Multiplies N = \u222b (h\u00b7n) p(h) dh, the facets' mean cosine, which scales the "
                    "whole highlight: p N F/(4 g(k1) g(k2)) (eq. 26). 1 is right for a height field; "
                    "slanted velvet takes 2 for the tops of its fibres."},
        mean_cosine_scale);
    return changed;
}

}  // namespace nacre::ui
