#include <imgui.h>

#include <string>

#include "ui/kind_fields.h"
#include "ui/layers_panel.h"

namespace nacre::ui {
namespace {

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

bool lobe_editor(Lobe& lobe, CurveView& curve) {
    const glm::dvec2 widths = widths_of(lobe);
    const bool chosen = kind_combo("Lobe", lobe, "", [&]<class T>() { return T::of_widths(widths); });
    return kind_fields(lobe, &curve) || chosen;
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
    picture_row("Picture", layer.modulation->image);
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
             "picture), renormalised to integrate to 1."},
        layer.modulation->strength);
    if (button("Remove picture##Remove modulation", "Leave the lobe as it is without the picture.")) {
        layer.modulation.reset();
        changed = true;
    }
    return changed;
}

}  // namespace

bool layer_editor(Layer& layer, CurveView& curve) {
    bool changed = text_field("Name##Layer name", layer.name, kind_label(layer.lobe),
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
