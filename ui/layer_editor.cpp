#include <imgui.h>

#include <string>

#include "ui/curve_editor.h"
#include "ui/layers_panel.h"
#include "ui/lobe_kinds.h"
#include "ui/widgets.h"

namespace nacre::ui {
namespace {

constexpr const char* sigma_x =
    "\u03c3x, the lobe's width along x (the tangent) as a slope: 0.01 is polished, 0.1 satin, 1 rough. "
    "Facets "
    "of this slope are 1/e as frequent as the middle: p ~ exp(\u2212(slope/\u03c3x)\u00b2).";
constexpr const char* sigma_y =
    "\u03c3y, the width along y (the bitangent). Unequal widths stretch the highlight across the wider one: "
    "brushed metal, hair, cloth. p ~ exp(\u2212(slope/\u03c3y)\u00b2).";
constexpr const char* alpha_x =
    "\u03b1x, the roughness along x (the tangent) as a slope: 0.01 is polished, 0.1 satin, 1 rough. The "
    "slopes "
    "of the surface spread as far as \u03b1x; the formula stands at the lobe's kind.";
constexpr const char* alpha_y =
    "\u03b1y, the roughness along y (the bitangent). Unequal ones stretch the highlight across the rougher "
    "direction: brushed metal, hair, cloth.";

SliderSpec width_spec(const char* label, const char* tooltip) {
    return {.label = label,
            .low = 1e-3,
            .high = 10,
            .least = limits::width_min,
            .most = limits::width_max,
            .reset = 0.2,
            .format = "%.4g",
            .logarithmic = true,
            .tooltip = tooltip};
}

SliderSpec angle_spec(const char* label, double low, double high, double most, const char* tooltip) {
    return {.label = label,
            .low = low,
            .high = high,
            .least = low < 0 ? -most : 0,
            .most = most,
            .reset = 0,
            .format = "%.1f\u00b0",
            .logarithmic = false,
            .tooltip = tooltip};
}

std::string picture_text(const Picture& picture) {
    const std::string where = picture.file.empty() ? "in the design" : picture.file.filename().string();
    if (!picture.raster) return where;
    return where + ", " + std::to_string(picture.raster->width) + " \u00d7 " +
           std::to_string(picture.raster->height);
}

void picture_rows(const Picture& picture) {
    text_row("Picture", picture_text(picture));
    notes_row(picture.notes);
}

// One function per lobe; std::visit calls the one that fits.
struct LobeFields {
    CurveView& curve;

    bool operator()(GaussianLobe& lobe) const {
        const bool x = slider_or_infinity(width_spec("Width x", sigma_x), lobe.sigma_x);
        return slider_or_infinity(width_spec("Width y", sigma_y), lobe.sigma_y) || x;
    }
    bool operator()(InverseGaussianLobe& lobe) const {
        SliderSpec spec =
            width_spec("Width",
                       "\u03c3: how far the fibres lean from upright, as a slope: small widths leave only "
                       "the rim glowing. p ~ exp(\u2212cot\u00b2\u03b8/\u03c3\u00b2).");
        spec.reset = InverseGaussianLobe{}.sigma;
        return slider(spec, lobe.sigma);
    }
    bool operator()(GgxLobe& lobe) const { return alphas(lobe.alpha_x, lobe.alpha_y); }
    bool operator()(BeckmannLobe& lobe) const { return alphas(lobe.alpha_x, lobe.alpha_y); }
    bool operator()(UniformLobe& lobe) const {
        static constexpr const char* domains[] = {"Hemisphere", "Whole sphere"};
        int index = lobe.domain == UniformDomain::sphere ? 1 : 0;
        const bool changed =
            combo("Facets over", index, domains,
                  "The upper hemisphere, or the whole sphere as for grains and fibres. A whole "
                  "sphere alone has no mean normal, so it needs another layer beside it.");
        if (changed) lobe.domain = index == 1 ? UniformDomain::sphere : UniformDomain::hemisphere;
        return changed;
    }
    bool operator()(CurveLobe& lobe) const { return curve_editor(curve, lobe); }
    bool operator()(PaintedLobe& lobe) const {
        picture_rows(lobe.image);
        return false;
    }

  private:
    static bool alphas(double& x, double& y) {
        const bool changed = slider(width_spec("Roughness x", alpha_x), x);
        return slider(width_spec("Roughness y", alpha_y), y) || changed;
    }
};

bool lobe_editor(Lobe& lobe, CurveView& curve) {
    int kind = static_cast<int>(lobe.index());
    bool changed = false;
    if (combo("Lobe", kind, lobe_names(), lobe_explanation(lobe.index()))) {
        lobe = converted_lobe(lobe, static_cast<std::size_t>(kind));
        changed = true;
    }
    return std::visit(LobeFields{curve}, lobe) || changed;
}

bool orientation(Layer& layer) {
    bool changed = slider(
        angle_spec("Rotation", -180, 180, limits::angle_max,
                   "Turns the lobe about its own axis, from x toward y: a stretched highlight turns with "
                   "it. h is turned back about z before p is asked."),
        layer.rotation);
    changed |= slider(
        angle_spec("Tilt", 0, 90, limits::tilt_max,
                   "Then leans the lobe's axis away from the surface normal by this angle \u03b8, and the "
                   "highlight moves to the other side. Slanted fibres and the sides of grooves are tilted "
                   "lobes."),
        layer.tilt);
    changed |= slider(angle_spec("Azimuth", -180, 180, limits::angle_max,
                                 "The direction toward which it leans: the axis is (sin \u03b8 cos \u03c6, "
                                 "sin \u03b8 sin \u03c6, cos "
                                 "\u03b8), \u03c6 from x toward y."),
                      layer.azimuth);
    return changed;
}

bool modulation(Layer& layer) {
    if (!layer.modulation) return false;
    ImGui::Spacing();
    heading("Modulated by a picture");
    picture_rows(layer.modulation->image);
    bool changed = slider(
        {.label = "Strength",
         .low = 0,
         .high = 1,
         .least = 0,
         .most = 1,
         .reset = 1,
         .format = "%.2f",
         .logarithmic = false,
         .tooltip =
             "How much of the picture multiplies the lobe: p times (1 \u2212 strength + strength \u00b7 "
             "picture), made 1 in all again."},
        layer.modulation->strength);
    if (button("Remove picture##Remove modulation", "Leave the lobe as it is without the picture.")) {
        layer.modulation.reset();
        changed = true;
    }
    return changed;
}

}  // namespace

bool layer_editor(Layer& layer, CurveView& curve) {
    bool changed = text_field("Name##Layer name", layer.name, lobe_names()[layer.lobe.index()],
                              "A name of your own for the list.");
    changed |= slider(
        {.label = "Weight",
         .low = 0,
         .high = 1,
         .least = 0,
         .most = limits::weight_max,
         .reset = 1,
         .format = "%.3g",
         .logarithmic = false,
         .tooltip = "This layer's share of the facets' area, relative to the other layers' weights: p = "
                    "\u2211 w p / \u2211 w, each layer's p of integral 1. Ctrl+click to type any number."},
        layer.weight);
    changed |= lobe_editor(layer.lobe, curve);
    ImGui::Spacing();
    changed |= orientation(layer);
    changed |= modulation(layer);
    return changed;
}

}  // namespace nacre::ui
