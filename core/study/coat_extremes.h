// Extreme designs under a coat.
#pragma once

#include <vector>

#include "core/study/extremes.h"

namespace nacre {

void add_coat_extremes(std::vector<ExtremeCase>& cases);

}  // namespace nacre
