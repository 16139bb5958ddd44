#include <fmt/format.h>

#include "core/model/spectral/spectral_colour.h"
#include "core/shading/surface.h"
#include "ui/kind_fields.h"
#include "ui/material_panel.h"

namespace nacre::ui {
namespace {

// What is not seen in the numbers of a table: how it became a colour, and what it cannot show.
void curve_notes(const FresnelCurve& curve, bool spectral) {
    if (spectral) dim_text(spectral_colour_rule);
    if (curve.clipped > 5e-4)
        dim_text(fmt::format("Colours are outside of Rec. 709 by up to {:.2g} and clipped.", curve.clipped));
    if (curve.error > 5e-3)
        warning_text(fmt::format("F turns faster than its table of {} nodes: off by up to {:.2g}.",
                                 curve.nodes, curve.error));
}

}  // namespace

bool fresnel_panel(Fresnel& fresnel) {
    const bool chosen = kind_combo("Fresnel", fresnel, "F(k\u00b7h), how much a facet mirrors at each angle.",
                                   [&]<class T>() { return T::of_reflectance(reflectance_of(fresnel)); });
    const bool changed = kind_fields(fresnel) || chosen;
    if (fresnel_is_curve(fresnel.index()) && !kind_fault(fresnel)) {
        const ShaderFresnel numbers = std::visit([](const auto& model) { return model.shader(); }, fresnel);
        curve_notes(*numbers.curve, !std::holds_alternative<CurveFresnel>(fresnel));
    }
    return changed;
}

}  // namespace nacre::ui
