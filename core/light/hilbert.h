// Hilbert's curve (1891): cells that follow each other along it touch, so that an interval of it is a compact
// patch.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <utility>

namespace nacre {

// The cell (column, row) of a square of `side` x `side` cells, side a power of two, at `index` along the
// curve.
inline glm::ivec2 hilbert_cell(std::int64_t index, int side) {
    glm::ivec2 cell{0};
    for (int size = 1; size < side; size *= 2, index /= 4) {
        const int right = static_cast<int>(index / 2 % 2);
        const int up = static_cast<int>((index ^ right) % 2);
        if (up == 0) {
            if (right == 1) cell = glm::ivec2(size - 1) - cell;
            std::swap(cell.x, cell.y);
        }
        cell += glm::ivec2(right, up) * size;
    }
    return cell;
}

}  // namespace nacre
