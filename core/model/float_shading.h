// A surface in float, as a GPU holds it.
#pragma once

#include "core/model/shading.h"

namespace nacre {

// Reads the same data, which must outlive it.
Shading<float> in_float(const Shading<double>& shading);

}  // namespace nacre
