// One tile of a moment pyramid, from its facets.
#pragma once

#include "core/model/pyramid_kernel.h"

namespace nacre {

// `facets` in Morton order, a power of four of them, at least 16, and the spread of each sixteen.
PyramidTile make_tile(const std::vector<Facet>& facets, const std::vector<Spread>& spreads);

// What k sees of one facet of a leaf, |k| = 1.
double visible_area(const LeafBlock& leaf, std::size_t facet, dvec3 k);

// Puts a cell at place 0 to 3 of a block; the ball grows by the rounding to float.
void put_cell(const PyramidCell& cell, std::size_t place, MomentBlock& moments, BallBlock& balls);

template <class Block>
dvec3 moment_at(const Block& block, std::size_t place) {
    return {block.x[place], block.y[place], block.z[place]};
}

// Row and column from a Morton index.
int morton_row(std::size_t index);
int morton_column(std::size_t index);

}  // namespace nacre
