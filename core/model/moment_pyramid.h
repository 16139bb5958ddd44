// g, its gradient and visible facets of a p that is a set of facets: a painted or modulated lobe.
#pragma once

#include <cstdint>

#include "core/model/lobe.h"

namespace nacre {

// A quadtree over a square grid of facets. Each cell holds m = sum of mass h over its facets and a ball
// around their directions: a cell wholly in front of k adds k.m, one wholly behind nothing, and only the
// cells that the great circle h.k = 0 passes are opened (MODEL.md, sec. 2). Equal to the sum over all facets.
class MomentPyramid {
  public:
    // `facets` row by row, side x side of them, side a power of two; mass 0 where the grid holds none.
    MomentPyramid(int side, const std::vector<Facet>& facets);

    Area area(dvec3 k) const;
    double mass() const { return mass_; }
    dvec3 mean() const { return nodes_.front().moment; }

    // The cells of the finest level with at most `count` of them (0: the facets themselves), empty ones left
    // out, each as one facet with the cell's own moment.
    std::vector<Facet> facets(std::size_t count) const;

    // Index (row * side + column) of a facet, drawn with the probability mass (h.k)+ / g(k); g(k) > 0.
    std::size_t sample_visible(dvec3 k, Random& random) const;

  private:
    struct Node {
        dvec3 moment{0};
        dvec3 centre{0};
        double radius = -1;  // of a ball that holds the facets' directions; < 0 when the cell is empty
    };

    void add(std::size_t node, dvec3 k, Area& sum) const;
    bool is_leaf(std::size_t node) const { return node >= first_leaf_; }

    int side_;
    std::size_t first_leaf_ = 0;
    double mass_ = 0;
    std::vector<Node> nodes_;  // children of i: 4 i + 1 ... 4 i + 4; leaves in Morton order
};

}  // namespace nacre
