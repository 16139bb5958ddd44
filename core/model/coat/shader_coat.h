#pragma once

#include <glm/vec3.hpp>

namespace nacre {

// What shaders/shared/coat.glsl reads.
struct ShaderCoat {
    double width = 0;     // that NAME_density() and NAME_area() of shaders/coat/NAME.glsl read
    double ior = 1;       // of the coat against air
    glm::dvec3 depth{0};  // optical depth of one way through it along n, each colour
};

}  // namespace nacre
