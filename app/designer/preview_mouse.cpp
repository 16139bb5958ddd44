#include "app/designer/preview_mouse.h"

#include <algorithm>
#include <cmath>

namespace nacre {
namespace {

constexpr double degrees = 180 / 3.14159265358979323846;
constexpr double normal_angle_max = 82;  // from the viewer: beyond it the light is all but behind
constexpr double degrees_per_pixel = 0.4;
constexpr double pitch_max = 89;
constexpr double zoom_per_notch = 1.1;
constexpr double zoom_min = 0.25;
constexpr double zoom_max = 8;

}  // namespace

void move_light_to(Scene& scene, const SurfaceImage& surface, glm::dvec2 pixel) {
    const auto point = surface.nearest(pixel);
    if (!point) return;
    // A mirror with normal n turns the view direction z into 2 (n.z) n - z: twice the angle, same azimuth.
    const glm::dvec3 normal = point->frame[2];
    const double angle = std::atan2(std::hypot(normal.x, normal.y), normal.z) * degrees;
    scene.light.theta = 2 * std::min(angle, normal_angle_max);
    if (normal.x != 0 || normal.y != 0) scene.light.phi = std::atan2(normal.y, normal.x) * degrees;
}

void orbit(Scene& scene, glm::dvec2 pixels) {
    scene.yaw = std::remainder(scene.yaw + pixels.x * degrees_per_pixel, 360.0);
    const double usual = scene.object.pitch;
    scene.pitch =
        std::clamp(scene.pitch + pixels.y * degrees_per_pixel, -pitch_max - usual, pitch_max - usual);
}

void zoom(Scene& scene, double wheel) {
    scene.zoom = std::clamp(scene.zoom * std::pow(zoom_per_notch, wheel), zoom_min, zoom_max);
}

}  // namespace nacre
