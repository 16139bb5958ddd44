#include "app/designer/scene_panel.h"

#include <algorithm>

#include "ui/widgets.h"

namespace nacre {
namespace {

struct LightLabels {
    const char* polar;
    const char* azimuth;
    const char* strength;
};

// Scales a colour by its strongest channel, so that a tint stays.
void strength_row(const char* label, double most, glm::dvec3& light, const glm::dvec3& usual,
                  const char* tooltip) {
    const auto strongest = [](const glm::dvec3& colour) { return std::max({colour.x, colour.y, colour.z}); };
    double strength = strongest(light);
    const ui::SliderSpec spec{.label = label,
                              .low = 0,
                              .high = most,
                              .least = 0,
                              .most = 1000,
                              .reset = strongest(usual),
                              .format = "%.2f",
                              .logarithmic = false,
                              .tooltip = tooltip};
    if (ui::slider(spec, strength)) light = usual * (strength / strongest(usual));
}

void light_rows(LightSource& light, const LightSource& usual, const LightLabels& labels) {
    ui::slider(
        {.label = labels.polar,
         .low = 0,
         .high = 180,
         .least = 0,
         .most = 180,
         .reset = usual.theta,
         .format = "%.1f\u00b0",
         .logarithmic = false,
         .tooltip = "Angle between the light and the viewer: 0 beside the eye, 90 from the side, 180 from "
                    "behind. Dragging on the sphere moves the light too."},
        light.theta);
    ui::slider({.label = labels.azimuth,
                .low = -180,
                .high = 180,
                .least = -360,
                .most = 360,
                .reset = usual.phi,
                .format = "%.1f\u00b0",
                .logarithmic = false,
                .tooltip = "Direction of the light around the view: 0 right, 90 above, 180 left."},
               light.phi);
    strength_row(
        labels.strength, 10, light.irradiance, usual.irradiance,
        "How bright the light is, its irradiance E: \u03c0 shows a white matt surface that faces it as "
        "white. Radiance = BRDF \u00b7 E cos \u03b8.");
}

void background_rows(Scene& scene, const Scene& usual) {
    // In the order of Background.
    constexpr const char* names[] = {"Dark wall", "Grey", "Black", "White", "Colour"};
    int index = static_cast<int>(scene.background);
    if (ui::combo("Background", index, names,
                  "The background. The wall follows the exposure; the others stay as they are."))
        scene.background = static_cast<Background>(index);
    if (scene.background == Background::custom)
        ui::colour("Colour##Background colour", scene.background_colour, usual.background_colour,
                   "The colour behind the object. Linear values; the swatch picks as displayed.");
}

void lights(Scene& scene) {
    const Scene usual;
    light_rows(scene.light, usual.light,
               {"Polar angle##Light polar angle", "Azimuth##Light azimuth", "Strength##Light strength"});
    ui::checkbox("Second light", scene.second_light, "A second light, from the side.");
    if (scene.second_light)
        light_rows(scene.second, usual.second,
                   {"Polar angle##Second light polar angle", "Azimuth##Second light azimuth",
                    "Strength##Second light strength"});
    ui::checkbox(
        "Rim light", scene.rim_light,
        "A light from behind: it draws the outline and shows what the surface does at grazing angles.");
    if (scene.rim_light)
        light_rows(scene.rim, usual.rim,
                   {"Polar angle##Rim light polar angle", "Azimuth##Rim light azimuth",
                    "Strength##Rim light strength"});
    ui::checkbox("Ambient light", scene.ambient,
                 "Light from everywhere, as strong from each direction: radiance = L times the albedo of k.");
    if (scene.ambient)
        strength_row("Strength##Ambient strength", 1, scene.ambient_radiance, usual.ambient_radiance,
                     "Radiance of the ambient light.");
}

}  // namespace

void reset_camera(Scene& scene) {
    const Scene usual;
    scene.yaw = usual.yaw;
    scene.pitch = usual.pitch;
    scene.zoom = usual.zoom;
}

void scene_panel(Scene& scene) {
    const Scene usual;
    if (lights_shine(scene)) lights(scene);
    ui::slider({.label = "Exposure",
                .low = -8,
                .high = 8,
                .least = -30,
                .most = 30,
                .reset = usual.exposure,
                .format = "%+.2f EV",
                .logarithmic = false,
                .tooltip = "Brightness of the picture: each step of 1 EV doubles it, radiance \u00b7 2^EV."},
               scene.exposure);
    background_rows(scene, usual);
    if (ui::button("Reset camera", "Back to the first view. Right drag orbits, the wheel zooms."))
        reset_camera(scene);
}

}  // namespace nacre
