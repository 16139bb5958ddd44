#include "app/preview/scene.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace nacre {
namespace {

constexpr double radians = std::numbers::pi / 180;
constexpr double sphere_part = 0.39;  // radius, of the picture's shorter side, at zoom 1

}  // namespace

std::vector<std::string> scene_names() { return {"single", "two", "ambient", "studio"}; }

std::optional<Scene> scene_by_name(std::string_view name) {
    const std::vector<std::string> names = scene_names();
    if (std::find(names.begin(), names.end(), name) == names.end()) return {};
    Scene scene;
    scene.second_light = name == "two" || name == "studio";
    scene.ambient = name == "ambient" || name == "studio";
    return scene;
}

bool gathers_light(const Scene& scene) { return scene.environment.picture && !is_factor(scene.term); }

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
    const glm::dmat3 lean{{1, 0, 0}, {0, cp, sp}, {0, -sp, cp}};
    return lean * turn;
}

double pixels_per_unit(const Scene& scene, glm::ivec2 size) {
    return sphere_part * scene.zoom * std::min(size.x, size.y);
}

}  // namespace nacre
