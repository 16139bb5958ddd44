#include "ui/kind_fields.h"
#include "ui/material_panel.h"

namespace nacre::ui {
bool shadowing_panel(Shadowing& shadowing, double& mean_cosine_scale) {
    bool changed = kind_combo(
        "Masking", shadowing.model,
        "Facets hide one another from the light and from the eye, which darkens grazing views. P(k) = N "
        "(k\u00b7n)/g(k) (eq. 25).",
        []<class T>() { return T{}; });
    changed |= kind_fields(shadowing.model);
    changed |= checkbox("Conserve energy##Clamp", shadowing.clamp,
                        "Masking never brightens: P = min(1, N (k\u00b7n)/g(k)), so no distribution reflects "
                        "more light than it gets. A p whose mean is tilted is dimmer for it on one side. "
                        "Off: the paper's own "
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
