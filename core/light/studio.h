// A photographer's room.
#pragma once

#include <glm/vec3.hpp>

namespace nacre {

// Radiance from a unit direction: soft boxes before dark walls.
glm::dvec3 studio_radiance(glm::dvec3 direction);

}  // namespace nacre
