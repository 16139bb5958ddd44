#pragma once

#include <glm/vec3.hpp>

namespace nacre {

// What the functions of shaders/diffuse/NAME.glsl read.
struct ShaderDiffuse {
    glm::dvec3 albedo{0};
    double kd = 0;
    double ks = 1;  // weight of the specular term
};

}  // namespace nacre
