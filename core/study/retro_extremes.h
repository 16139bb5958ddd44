// Extreme designs that are retro-reflective.
#pragma once

#include <vector>

#include "core/study/extremes.h"

namespace nacre {

void add_retro_extremes(std::vector<ExtremeCase>& cases);

}  // namespace nacre
