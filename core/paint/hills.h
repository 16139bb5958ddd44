// The hills of a picture of paint.
#pragma once

#include <optional>
#include <vector>

#include "core/image/raster.h"

namespace nacre {

inline constexpr int hill_cells = 128;  // a side of the grid on which hills are found

// 1 on the cells (row-major, hill_cells a side) of the hill to which one cell belongs, 0 elsewhere; nothing
// where there is no paint near that cell. See Highlight for what a hill is.
std::optional<std::vector<float>> hill_around(const Raster& raster, int row, int column);

}  // namespace nacre
