// What a pointer on the preview does to the scene. Plain arithmetic, no interface.
#pragma once

#include <glm/vec2.hpp>

#include "app/preview/scene.h"
#include "app/preview/surface_image.h"

namespace nacre {

// Places the light so that the highlight of a mirror lies under the pixel. Beyond the object's edge the
// highlight stays at the edge.
void move_light_to(Scene& scene, const SurfaceImage& surface, glm::dvec2 pixel);

void orbit(Scene& scene, glm::dvec2 pixels);
void zoom(Scene& scene, double wheel);

}  // namespace nacre
