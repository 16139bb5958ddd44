#pragma once

#include <glm/vec3.hpp>

namespace nacre {

// What NAME_fresnel(a, b, cosine) of the shader reads.
struct ShaderFresnel {
    glm::dvec3 a{0};
    glm::dvec3 b{0};
};

// What the tables of R hold besides R with F = 1.
enum class FresnelTables {
    none,    // F = 1
    linear,  // R with Schlick's weight, in which R is linear: a is f0
    exact    // R with the design's own F, one table for each colour
};

}  // namespace nacre
