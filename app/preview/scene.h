// What lights the sphere and from where it is seen: nothing of the design.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/preview/object.h"
#include "core/light/environment.h"
#include "core/shading/term.h"

namespace nacre {

// Small and distant. Angles in degrees in view space (x right, y up, z toward the viewer): theta from the
// viewer, phi from right toward up.
struct LightSource {
    double theta = 42;
    double phi = 125;
    glm::dvec3 irradiance{4.5};  // on a surface that faces it; pi shows a white Lambertian surface as 1

    bool operator==(const LightSource&) const = default;
};

// Light from all around, and whether it is seen behind the object. It stays with the viewer while the object
// turns.
struct SceneEnvironment {
    std::shared_ptr<const Environment> picture;  // none: the lights alone
    double rotation = 0;    // degrees about the vertical: what is behind the object moves right
    double brightness = 1;  // factor
    bool visible = false;
    bool with_lights = false;  // the scene's lights shine too

    bool operator==(const SceneEnvironment&) const = default;
};

// The wall is lit as the object is, dark and brighter behind it; the others are shown as they are named,
// whatever the exposure.
enum class Background { wall, grey, black, white, custom };

struct Scene {
    SceneObject object;
    LightSource light;
    bool second_light = false;
    LightSource second{75, -25, {0.9, 1.0, 1.2}};
    bool rim_light = false;  // from behind, opposite to the main light
    LightSource rim{128, -50, {5.5, 6.0, 7.0}};
    bool ambient = false;
    glm::dvec3 ambient_radiance{0.12};
    SceneEnvironment environment;
    double exposure = 0;  // EV
    Background background = Background::wall;
    glm::dvec3 background_colour{0.5, 0.5, 0.5};  // of Background::custom, linear sRGB as it is shown
    double yaw = 0;                               // degrees, orbit about the object's y axis
    double pitch = 0;                             // degrees, tilts the axis toward the viewer
    double zoom = 1;
    Term term = Term::total;  // what of the surface's BRDF is shown; a factor is that of the main light

    bool operator==(const Scene&) const = default;
};

// "single" (one light, as in the paper's figures), "two", "ambient", "studio" (all of them).
std::vector<std::string> scene_names();
std::optional<Scene> scene_by_name(std::string_view name);

// Whether an environment lights what is shown: a factor of the BRDF is that of the main light.
bool uses_environment(const Scene& scene);

// Whether the lights shine: where an environment does, only if they are to.
bool lights_shine(const Scene& scene);

// Those that shine, the main one first; none where an environment stands in for them, but for what shows a
// factor of the main light.
std::vector<LightSource> lights_of(const Scene& scene);

// What surface.frag takes for the background: the radiance in its middle, and whether it falls off like the
// wall's.
struct Backdrop {
    glm::dvec3 radiance{0};
    bool falls_off = false;
};
Backdrop backdrop_of(const Scene& scene);

// Unit vector toward a light, view space.
glm::dvec3 light_direction(const LightSource& light);

// The object turns by yaw about its own y axis, which is then tilted toward the viewer by its own pitch and
// the camera's.
glm::dmat3 object_to_view(const Scene& scene);

// Pixels that one unit of view space (about the object's radius) takes.
double pixels_per_unit(const Scene& scene, glm::ivec2 size);

}  // namespace nacre
