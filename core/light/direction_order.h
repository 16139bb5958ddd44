// Directions of equal mass in an order to draw from: one number in [0, 1) picks one as a plane sees it.
//
// Facets of p that k sees, and light that a surface with the normal n sees, are the same draw: a mass over
// the sphere, weighted by (d.k)+. Both are laid out along a space-filling curve, near ones side by side,
// under a tree with the mean of each range. A point of a low-discrepancy sequence on [0, 1) then becomes a
// direction by descent, each range being chosen by what k sees of it (hierarchical warping: Clarberg et al.
// 2005; space-filling curves: Steigleder & McCool 2003), and stays well spread (He & Owen 2016).
// shaders/draw.glsl draws.
#pragma once

#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <vector>

namespace nacre {

// Levels of ranges, each split into four; the ranges of the last hold `leaf_size` directions.
inline constexpr int order_levels = 5;
inline constexpr int order_leaves = 1 << (2 * order_levels);
inline constexpr int order_leaf_size = 64;
inline constexpr int order_count = order_leaves * order_leaf_size;
inline constexpr int order_nodes = (4 * order_leaves - 4) / 3;

struct DirectionOrder {
    // order_nodes ranges, level by level from the four widest: the mean of their directions, and the root
    // mean square distance from it; then the order_count unit directions, with 0.
    std::vector<glm::vec4> texels;
};

// A mass over patches of the sphere.
struct MassCells {
    std::vector<double> mass;  // of each cell, in the order to be kept; >= 0
    // The direction at a place in [0, 1)^2 of a cell. Called from several threads.
    std::function<glm::dvec3(std::size_t cell, glm::dvec2 at)> direction;
};

// Each cell gets directions by its share of the mass, evenly scattered over it. Some mass must be positive.
DirectionOrder order_directions(const MassCells& cells);

}  // namespace nacre
