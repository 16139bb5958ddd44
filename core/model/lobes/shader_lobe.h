#pragma once

#include <glm/vec2.hpp>
#include <vector>

namespace nacre {

// What NAME_lobe() of the shader reads of a Layer.
struct ShaderLobe {
    glm::dvec2 inverse_width{0};
    int data_size = 0;
    std::vector<float> data = {};
    double unit = 1;  // p is this times what the shader makes of the data
};

}  // namespace nacre
