// A lobe's density at many directions side by side, in vectors as wide as the processor has.
#pragma once

#include "core/model/lobe.h"
#include "core/model/shading.h"

namespace nacre {

// A lobe by the numbers that its density reads: those of the shader's Layer (shaders/shared/parameters.glsl).
struct LobeForm {
    int kind;  // Shading<double>::LOBE_*
    dvec2 inverse_width{0};
    const float* data = nullptr;  // of a curve or a picture
    int data_size = 0;
};

// What LobeModel::density() gives, to a few units in the last place, by lobe_density() of
// shaders/shared/lobes.glsl. `p` takes h.size numbers.
void lobe_densities(const LobeForm& lobe, const DirectionColumns& h, double* p);

}  // namespace nacre
