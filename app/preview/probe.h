// Which facets light which pixels of the object, and the other way round. Of the main light alone.
#pragma once

#include <cstdint>
#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "app/preview/scene.h"
#include "app/preview/surface_image.h"

namespace nacre {

// The half vector of light and viewer at a pixel (from the top left corner), in the surface's frame there:
// the normal of the facets that light the pixel. Nothing beside the object or where the light does not reach.
std::optional<glm::dvec3> half_vector(const Scene& scene, const SurfaceImage& surface, glm::dvec2 pixel);

// A veil over what facets light.
struct Veil {
    std::function<double(glm::dvec3 h)> strength;  // over facets of normal h, 0 to 1; null: no veil
    int texel = 2;                                 // its fineness, pixels
};

// Over what facets within about `radius` degrees of `middle` light, softly.
Veil spot(glm::dvec3 middle, double radius);

// A veil over the preview that shines: straight RGBA, rows from the top, in texels of the veil.
struct Glow {
    glm::ivec2 size{0};
    std::vector<std::uint8_t> rgba;
};
Glow glow_of(const Scene& scene, const SurfaceImage& surface, const Veil& veil);

}  // namespace nacre
