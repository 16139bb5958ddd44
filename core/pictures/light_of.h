// Colours as they are stored to linear light.
#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "core/pictures/decoder.h"

namespace nacre {

// Linear Rec. 709, times alpha once.
class LightOf {
  public:
    explicit LightOf(const PictureHeader& header);
    glm::dvec3 operator()(const glm::vec4& pixel) const;

  private:
    double decoded(double value) const;

    PictureHeader header_;
    std::vector<double> table_;  // of the 65536 values of 16 bits, which those of 8 bits are among
};

}  // namespace nacre
