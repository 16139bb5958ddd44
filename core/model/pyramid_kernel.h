// The walk of a moment pyramid, four children of a node at once in vectors as wide as the processor has.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "core/model/spread.h"

namespace nacre {

// What a pyramid knows of four sibling cells: m = sum of mass h over each one's facets, and a ball around
// their directions, rounded outward; a radius < 0 marks a cell that holds no facets.
struct MomentBlock {
    double x[4], y[4], z[4];
};
struct BallBlock {
    float x[4], y[4], z[4], radius[4];
};

// One cell; a radius < 0 as above.
struct PyramidCell {
    dvec3 moment{0};
    dvec3 centre{0};
    double radius = -1;
};

// m of the facets of one cell of the finest level, 4 x 4 of them in Morton order, and how far each one's
// patch spreads: `share` times the spread, which is the mass but where the patch would reach past the lobe's
// horizon.
struct LeafBlock {
    double x[16], y[16], z[16], share[16];
    Spread spread;
};

// A quadtree over a square of facets. Block i holds the children of node i, node 0 being the root. Node
// 4 i + 1 + j is its child j; nodes from balls.size() on are leaves.
struct PyramidTile {
    std::vector<MomentBlock> moments;
    std::vector<BallBlock> balls;
    std::vector<LeafBlock> leaves;
    PyramidCell root;
    double mass = 0;
};

// Facets a side of a tile. A dab touches a few tiles, and the tiles of a raster fill a few blocks.
inline constexpr int tile_side_max = 64;

// Nodes of a tile of that side, all sizes and the leaves among them: 1 + 4 + 16 + ... + leaves.
inline constexpr std::size_t tile_nodes_max = [] {
    constexpr std::size_t leaves_a_side = tile_side_max / 4;
    constexpr std::size_t leaves = leaves_a_side * leaves_a_side;
    static_assert((leaves & (leaves - 1)) == 0, "a power of four");
    return (4 * leaves - 1) / 3;
}();

// The tiles' own cells, four to a block, and the tiles beneath them.
struct PyramidTop {
    std::vector<MomentBlock> moments;
    std::vector<BallBlock> balls;
    std::vector<std::shared_ptr<const PyramidTile>> tiles;
};

// Over all facets: g alone, and with its gradient. |k| = 1.
double sum_visible_area(const PyramidTop& top, dvec3 k);
Area sum_visible(const PyramidTop& top, dvec3 k);

// g over the facets beneath one node of a tile.
double sum_visible_area(const PyramidTile& tile, std::size_t node, dvec3 k);

}  // namespace nacre
