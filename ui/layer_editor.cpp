#include <imgui.h>

#include <cmath>
#include <string>

#include "core/paint/layer_paint.h"
#include "core/paint/lobe_handles.h"
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

bool kind_of_lobe(Lobe& lobe) {
    const glm::dvec2 widths = widths_of(lobe);
    return kind_combo("Lobe", lobe, "", [&]<class T>() { return T::of_widths(widths); });
}

// What has been changed of one width is done to the other.
void keep_stretch(Lobe& lobe, const LobeShape& before) {
    const auto after = shape_of(lobe);
    if (!after || after->stretch == before.stretch) return;
    // The width that was changed times its change, which is the stretch's or its inverse.
    const double by_x = after->softness / before.softness * std::sqrt(after->stretch / before.stretch);
    const double by_y = after->softness / before.softness / std::sqrt(after->stretch / before.stretch);
    const double factor = std::abs(by_x - 1) > std::abs(by_y - 1) ? by_x : by_y;
    set_shape(lobe, {before.softness * factor, before.stretch});
}

bool lobe_fields(Lobe& lobe, LayersView& view) {
    const auto before = shape_of(lobe);
    const bool changed = kind_fields(lobe, &view.curve);
    if (changed && before && view.linked) keep_stretch(lobe, *before);
    if (before)
        checkbox(
            "Link x and y", view.linked,
            "A change of one width changes the other by the same factor, so that the highlight keeps its "
            "stretch.");
    return changed;
}

// What an artist calls softness, stretch and direction.
bool artists_fields(Layer& layer) {
    auto shape = shape_of(layer.lobe);
    if (!shape) return false;
    bool changed =
        slider({.label = "Softness",
                .low = 0.003,
                .high = 1,
                .least = limits::width_min,
                .most = 10,
                .reset = default_width,
                .format = "%.3g",
                .logarithmic = true,
                .tooltip = "How wide the highlight glows: 0.01 is polished, 0.1 satin, 1 dull. The "
                           "mean of both widths, as a slope."},
               shape->softness);
    changed |= slider({.label = "Stretch",
                       .low = 0.05,
                       .high = 20,
                       .least = 1e-3,
                       .most = 1e3,
                       .reset = 1,
                       .format = "%.3g",
                       .logarithmic = true,
                       .tooltip = "How long the highlight is along its direction, for 1 across: 1 is round, "
                                  "10 a streak as on brushed metal."},
                      shape->stretch);
    if (changed) set_shape(layer.lobe, *shape);
    return changed;
}

bool direction(Layer& layer) {
    return slider(
        angle_spec("Direction##Rotation", -180, 180, limits::angle_max,
                   "Turns the lobe about its own axis, from x toward y: what is stretched along x at "
                   "0\u00b0 is along y at 90\u00b0. h is turned back about z before p is evaluated."),
        layer.rotation);
}

bool orientation(Layer& layer) {
    bool changed = direction(layer);
    changed |= slider(
        angle_spec("Tilt", 0, 90, limits::tilt_max,
                   "Then tilts the lobe's axis away from the surface normal by this angle \u03b8, and the "
                   "highlight moves to the other side. Slanted fibres and the sides of grooves are tilted "
                   "lobes."),
        layer.tilt);
    changed |= slider(angle_spec("Azimuth", -180, 180, limits::angle_max,
                                 "The direction of the tilt: the axis is (sin \u03b8 cos \u03c6, "
                                 "sin \u03b8 sin \u03c6, cos \u03b8), \u03c6 from x toward y."),
                      layer.azimuth);
    return changed;
}

// Its mask: a picture that multiplies the lobe, painted or read from a file.
bool mask(Layer& layer, bool& paints_mask) {
    ImGui::Spacing();
    heading("Mask");
    bool changed = false, painting = paints_mask && layer.modulation;
    if (checkbox(
            "Paint the mask", painting,
            "Every tool of the canvas paints what of this layer shows, instead of the layer: white shows, "
            "black hides. A new mask shows all that lies above the lobe's horizon.")) {
        paints_mask = painting;
        if (painting && !layer.modulation) layer.modulation = open_mask(), changed = true;
    }
    if (!layer.modulation) return changed;
    picture_row("Picture", layer.modulation->image);
    changed |= slider(
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
    if (button("Remove mask##Remove modulation", "Leave the lobe as it is without the mask.")) {
        layer.modulation.reset();
        changed = true;
    }
    return changed;
}

}  // namespace

bool layer_editor(Layer& layer, LayersView& view, bool& paints_mask) {
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
    changed |= artists_fields(layer);
    if (!view.expert) changed |= direction(layer);
    changed |=
        colour("Colour##Layer tint", layer.tint, glm::dvec3(1),
               "The colour that this layer's facets reflect, on top of the material's own. The share that "
               "they do not reflect is lost, so that energy and reciprocity hold.");
    if (view.expert) {
        changed |= kind_of_lobe(layer.lobe);
        if (!std::holds_alternative<PaintedLobe>(layer.lobe)) layer.source.reset();
        changed |= lobe_fields(layer.lobe, view);
        ImGui::Spacing();
        changed |= orientation(layer);
    } else if (!shape_of(layer.lobe)) {
        changed |= lobe_fields(layer.lobe, view);
    }
    source_editor(layer, view);
    changed |= mask(layer, paints_mask);
    return changed;
}

}  // namespace nacre::ui
