#include "app/preview/probe.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace nacre {
namespace {

constexpr double strongest = 0.8;  // opacity
constexpr double strongest_spot = 0.75;
constexpr glm::u8vec3 colour{120, 235, 225};

std::optional<glm::dvec3> half_vector(const SurfaceImage& surface, glm::dvec3 light, glm::dvec2 pixel) {
    const auto point = surface.at(pixel);
    if (!point) return {};
    const glm::dvec3 normal = point->frame[2];
    if (glm::dot(light, normal) <= 0 || normal.z <= 0) return {};
    return glm::normalize(light + glm::dvec3(0, 0, 1)) * point->frame;
}

}  // namespace

std::optional<glm::dvec3> half_vector(const Scene& scene, const SurfaceImage& surface, glm::dvec2 pixel) {
    return half_vector(surface, light_direction(scene.light), pixel);
}

Veil spot(glm::dvec3 middle, double radius) {
    const auto strength = [middle, width = radius * (std::numbers::pi / 180)](glm::dvec3 h) {
        const double distance = glm::length(h - middle) / width;
        return strongest_spot * std::exp(-distance * distance);
    };
    return {strength, 4};
}

Glow glow_of(const Scene& scene, const SurfaceImage& surface, const Veil& veil) {
    const glm::dvec3 light = light_direction(scene.light);
    Glow glow;
    glow.size = glm::max((surface.size() + veil.texel - 1) / veil.texel, glm::ivec2(1));
    glow.rgba.reserve(static_cast<std::size_t>(glow.size.x * glow.size.y) * 4);
    for (int row = 0; row < glow.size.y; ++row)
        for (int column = 0; column < glow.size.x; ++column) {
            const glm::dvec2 pixel = glm::dvec2(column + 0.5, row + 0.5) * static_cast<double>(veil.texel);
            const auto here = half_vector(surface, light, pixel);
            const double alpha = here ? strongest * veil.strength(*here) : 0;
            glow.rgba.insert(glow.rgba.end(), {colour.x, colour.y, colour.z,
                                               static_cast<std::uint8_t>(std::lround(255 * alpha))});
        }
    return glow;
}

}  // namespace nacre
