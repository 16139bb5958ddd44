#include "app/preview/probe.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <numbers>

namespace nacre {
namespace {

constexpr double strongest = 0.6;  // opacity
constexpr glm::u8vec3 colour{120, 235, 225};

// As tangent_frame() of shaders/sphere.frag.
glm::dmat3 tangent_frame(const glm::dmat3& object, glm::dvec3 normal) {
    const glm::dvec3 east = glm::cross(object[1], normal);
    const double length = glm::length(east);
    const glm::dvec3 tangent = length > 1e-6 ? east / length : object[0];
    return {tangent, glm::cross(normal, tangent), normal};
}

std::optional<glm::dvec3> half_vector(const Scene& scene, const glm::dmat3& object, glm::dvec3 light,
                                      glm::dvec2 pixel, glm::ivec2 size) {
    const auto normal = sphere_point(scene, pixel, size);
    if (!normal || glm::dot(light, *normal) <= 0 || normal->z <= 0) return {};
    return glm::normalize(light + glm::dvec3(0, 0, 1)) * tangent_frame(object, *normal);
}

}  // namespace

std::optional<glm::dvec3> half_vector(const Scene& scene, glm::dvec2 pixel, glm::ivec2 size) {
    return half_vector(scene, object_to_view(scene), light_direction(scene.light), pixel, size);
}

Glow glow_of(const Scene& scene, glm::ivec2 size, glm::dvec3 h, double radius, int divisor) {
    const glm::dmat3 object = object_to_view(scene);
    const glm::dvec3 light = light_direction(scene.light);
    const double width = radius * (std::numbers::pi / 180);
    Glow glow;
    glow.size = glm::max((size + divisor - 1) / divisor, glm::ivec2(1));
    glow.rgba.reserve(static_cast<std::size_t>(glow.size.x * glow.size.y) * 4);
    for (int row = 0; row < glow.size.y; ++row)
        for (int column = 0; column < glow.size.x; ++column) {
            const glm::dvec2 pixel = glm::dvec2(column + 0.5, row + 0.5) * static_cast<double>(divisor);
            const auto here = half_vector(scene, object, light, pixel, size);
            const double distance = here ? glm::length(*here - h) / width : HUGE_VAL;
            const double alpha = strongest * std::exp(-distance * distance);
            glow.rgba.insert(glow.rgba.end(), {colour.x, colour.y, colour.z,
                                               static_cast<std::uint8_t>(std::lround(255 * alpha))});
        }
    return glow;
}

}  // namespace nacre
