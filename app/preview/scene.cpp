#include "app/preview/scene.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/preview/filmic.h"

namespace nacre {
namespace {

constexpr double radians = std::numbers::pi / 180;
constexpr double sphere_part = 0.39;  // radius, of the picture's shorter side, at zoom 1

constexpr glm::dvec3 wall{0.045, 0.047, 0.052};  // radiance
constexpr double middle_grey = 0.18;

glm::dvec3 shown_background(const Scene& scene) {
    switch (scene.background) {
        case Background::grey:
            return glm::dvec3(middle_grey);
        case Background::white:
            return glm::dvec3(1);
        case Background::custom:
            return scene.background_colour;
        case Background::wall:
        case Background::black:
            break;
    }
    return glm::dvec3(0);
}

}  // namespace

std::vector<LightSource> lights_of(const Scene& scene) {
    if (!lights_shine(scene) && !is_factor(scene.term)) return {};
    std::vector<LightSource> lights{scene.light};
    if (scene.second_light) lights.push_back(scene.second);
    if (scene.rim_light) lights.push_back(scene.rim);
    return lights;
}

Backdrop backdrop_of(const Scene& scene) {
    if (scene.background == Background::wall) return {wall, true};
    const glm::dvec3 shown = shown_background(scene);
    const double exposure = std::exp2(scene.exposure);
    return {glm::dvec3(unfilmic(shown.x), unfilmic(shown.y), unfilmic(shown.z)) / exposure, false};
}

std::vector<std::string> scene_names() { return {"single", "two", "ambient", "studio"}; }

std::optional<Scene> scene_by_name(std::string_view name) {
    const std::vector<std::string> names = scene_names();
    if (std::find(names.begin(), names.end(), name) == names.end()) return {};
    Scene scene;
    scene.second_light = name == "two" || name == "studio";
    scene.ambient = name == "ambient" || name == "studio";
    return scene;
}

bool uses_environment(const Scene& scene) { return scene.environment.picture && !is_factor(scene.term); }

bool lights_shine(const Scene& scene) { return !scene.environment.picture || scene.environment.with_lights; }

glm::dvec3 light_direction(const LightSource& light) {
    const double sine = std::sin(light.theta * radians);
    return {sine * std::cos(light.phi * radians), sine * std::sin(light.phi * radians),
            std::cos(light.theta * radians)};
}

glm::dmat3 object_to_view(const Scene& scene) {
    const double cy = std::cos(scene.yaw * radians), sy = std::sin(scene.yaw * radians);
    const double pitch = (scene.object.pitch + scene.pitch) * radians;
    const double cp = std::cos(pitch), sp = std::sin(pitch);
    const glm::dmat3 turn{{cy, 0, -sy}, {0, 1, 0}, {sy, 0, cy}};
    const glm::dmat3 pitch_matrix{{1, 0, 0}, {0, cp, sp}, {0, -sp, cp}};
    return pitch_matrix * turn;
}

double pixels_per_unit(const Scene& scene, glm::ivec2 size) {
    return sphere_part * scene.zoom * std::min(size.x, size.y);
}

}  // namespace nacre
