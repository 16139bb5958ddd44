// Patches of facets in a tree by which one is drawn, whatever direction they are seen from, in a few steps.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/model/lobe_model.h"

namespace nacre {

// Of a patch's facets: their mass, and a ball that holds their directions, its centre a unit vector.
struct PatchBall {
    dvec3 centre;
    double radius;
    double mass;
};

inline constexpr std::size_t tree_children = 16;

// Sixteen nodes, each with the mass of its patches, their mean centre m, the factor L of their centres'
// covariance (columns of a lower triangle), how far any patch reaches from m, and their mean radius; see
// PatchTree. A node without patches reaches -1.
struct alignas(64) PatchBlock {
    float m[3][tree_children];
    float l[6][tree_children];  // xx, xy, xz, yy, yz, zz
    float reach[tree_children];
    float radius[tree_children];
    float mass[tree_children];
};

// What k may see of sixteen nodes, in fours of every fourth: rising sums within each four, and of the fours
// before each.
struct PatchView {
    alignas(64) float rising[4 + tree_children];
    double before[4];
    double all;
    float k[3];
};

// A way down: `left` is a number in [0, from->all).
struct PatchDescent {
    const PatchView* from;
    double left;
    std::size_t leaf;
};

// k sees at most (c.k)+ + r of a patch of mass 1, and nothing where c.k + r < 0. Of all patches below a node
// it sees at most
//
//     mass ((m.k + sqrt((m.k)^2 + |L'k|^2))/2 + r)
//
// because (c.k)+ is half of c.k + |c.k|, and Schwarz's inequality bounds the mean of |c.k| by the root of the
// mean square. For the same reason that is no less than the sum of the children's bounds: a number between 0
// and the root's bound that falls on a child's is drawn further within it, and one that falls beyond them all
// is drawn in vain (docs/mathematics.md, sec. 22).
class PatchTree {
  public:
    static constexpr std::size_t none = ~std::size_t{0};

    explicit PatchTree(const std::vector<PatchBall>& patches);

    // The tree's leaves: which of the patches each is, or none.
    const std::vector<std::size_t>& order() const { return order_; }

    // |k| = 1.
    PatchView view(dvec3 k) const;

    // Each to a leaf, and to what is left of `left` within the leaf's own share; to none where it is drawn in
    // vain.
    void descend(std::span<PatchDescent> descents) const;

  private:
    void fill(const std::vector<PatchBall>& patches, std::span<std::size_t> items, std::size_t level,
              std::size_t block);
    std::size_t first_leaf() const;

    std::vector<std::size_t> order_;
    std::vector<PatchBlock> blocks_;  // level by level: below node i of block b is block 16 b + i + 1
    std::size_t levels_ = 0;
};

}  // namespace nacre
