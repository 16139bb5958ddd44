// What lights the sphere and from where it is seen: nothing of the design.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/bake/term.h"

namespace nacre {

// Small and distant. Angles in degrees in view space (x right, y up, z toward the viewer): theta from the
// viewer, phi from right toward up.
struct LightSource {
    double theta = 42;
    double phi = 125;
    glm::dvec3 irradiance{4.5};  // on a surface that faces it; pi shows a white Lambertian surface as 1

    bool operator==(const LightSource&) const = default;
};

struct Scene {
    LightSource light;
    bool second_light = false;
    LightSource second{75, -25, {0.9, 1.0, 1.2}};
    bool ambient = false;
    glm::dvec3 ambient_radiance{0.12};
    double exposure = 0;  // EV
    double yaw = 0;       // degrees, orbit about the sphere's axis
    double pitch = 0;     // degrees, the axis leans toward the viewer
    double zoom = 1;
    Term term = Term::total;  // what of the surface's BRDF is shown; a factor is that of the main light

    bool operator==(const Scene&) const = default;
};

// "single" (one light, as in the paper's figures), "two", "ambient", "studio" (all of them).
std::vector<std::string> scene_names();
std::optional<Scene> scene_by_name(std::string_view name);

// Unit vector toward a light, view space.
glm::dvec3 light_direction(const LightSource& light);

// The sphere turns by yaw about its own axis, which then leans toward the viewer by pitch.
glm::dmat3 object_to_view(const Scene& scene);

// Pixels that one unit of view space (the sphere's radius) takes.
double pixels_per_unit(const Scene& scene, glm::ivec2 size);

}  // namespace nacre
