#include "app/designer/preview_mouse.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "app/preview/preview.h"

namespace nacre {
namespace {

constexpr double degrees = 180 / 3.14159265358979323846;
constexpr double normal_angle_most = 82;  // from the viewer: beyond it the light is all but behind
constexpr double degrees_per_pixel = 0.4;
constexpr double pitch_most = 89;
constexpr double zoom_per_notch = 1.1;
constexpr double zoom_least = 0.25;
constexpr double zoom_most = 8;

// The point of the sphere nearest to the pixel on the way to the middle of the picture.
std::optional<glm::dvec3> nearest_point(const Scene& scene, glm::dvec2 pixel, glm::ivec2 size) {
    if (const auto hit = sphere_point(scene, pixel, size)) return hit;
    glm::dvec2 inside = glm::dvec2(size) * 0.5;
    glm::dvec2 outside = pixel;
    for (int step = 0; step < 20; ++step) {
        const glm::dvec2 middle = (inside + outside) * 0.5;
        (sphere_point(scene, middle, size) ? inside : outside) = middle;
    }
    return sphere_point(scene, inside, size);
}

}  // namespace

void move_light_to(Scene& scene, glm::dvec2 pixel, glm::ivec2 size) {
    const auto normal = nearest_point(scene, pixel, size);
    if (!normal) return;
    // A mirror with normal n turns the view direction z into 2 (n.z) n - z: twice the angle, same azimuth.
    const double angle = std::acos(std::clamp(normal->z, -1.0, 1.0)) * degrees;
    scene.light.theta = 2 * std::min(angle, normal_angle_most);
    if (normal->x != 0 || normal->y != 0) scene.light.phi = std::atan2(normal->y, normal->x) * degrees;
}

void orbit(Scene& scene, glm::dvec2 pixels) {
    scene.yaw = std::remainder(scene.yaw + pixels.x * degrees_per_pixel, 360.0);
    scene.pitch = std::clamp(scene.pitch + pixels.y * degrees_per_pixel, -pitch_most, pitch_most);
}

void zoom(Scene& scene, double wheel) {
    scene.zoom = std::clamp(scene.zoom * std::pow(zoom_per_notch, wheel), zoom_least, zoom_most);
}

}  // namespace nacre
