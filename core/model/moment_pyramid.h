// g, its gradient and visible facets of a p that is a set of facets: a painted or modulated lobe.
#pragma once

#include <functional>

#include "core/model/pyramid_kernel.h"

namespace nacre {

// A quadtree over a square grid of facets, in tiles that copies share: a copy with some facets changed costs
// what was changed. Everything is equal to the sum over all facets but for rounding.
class MomentPyramid {
  public:
    // The facet at (row, column); mass 0 where the grid holds none. Called from several threads.
    using FacetAt = std::function<Facet(int row, int column)>;

    // How far the facets' patches spread near (row, column), a place between some of them; facets without
    // patches where this is none.
    using SpreadAt = std::function<Spread(double row, double column)>;

    // Rows and columns, the ends not included.
    struct Part {
        int row_begin, row_end, column_begin, column_end;
    };

    // side x side facets, side a power of two, at least 4.
    MomentPyramid(int side, const FacetAt& facet_at, const SpreadAt& spread_at = {});

    // Of tiles that lie anywhere, each of tile_side_max facets a side. sample_visible() counts the rows of
    // one after those of the other.
    explicit MomentPyramid(std::vector<std::shared_ptr<const PyramidTile>> tiles);

    // Bit-identical to a pyramid rebuilt from `facet_at`, which differs from this one within
    // `part`.
    MomentPyramid changed(const Part& part, const FacetAt& facet_at, const SpreadAt& spread_at = {}) const;

    double projected_area(dvec3 k) const { return sum_visible_area(top_, k); }
    Area area(dvec3 k) const { return sum_visible(top_, k); }
    double mass() const { return mass_; }
    dvec3 mean() const { return mean_; }

    // At most `count` cells (0: the facets themselves) that hold all of them, each as one facet with the
    // cell's own moment: the cell with the largest error, by mass and square of size, is split first.
    std::vector<Facet> facets(std::size_t count) const;

    // All facets, sixteen at a time.
    void visit_leaves(const std::function<void(const LeafBlock&)>& visit) const;

    // Index (row * side + column) of a facet, drawn with the probability mass (h.k)+ / g(k); g(k) > 0.
    std::size_t sample_visible(dvec3 k, Random& random) const;

  private:
    MomentPyramid() = default;
    void add_up();

    int side_ = 0, tile_side_ = 0, tiles_ = 0;  // facets a side; facets a tile's side; tiles a side
    PyramidTop top_;
    double mass_ = 0;
    dvec3 mean_{0};
};

}  // namespace nacre
