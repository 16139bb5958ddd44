// A rule of integration over the facets of a lobe that holds a picture.
#pragma once

#include <array>
#include <cmath>
#include <stop_token>
#include <vector>

#include "core/bake/bake.h"
#include "core/model/quadrature.h"
#include "core/verify/picture_tree.h"

namespace nacre {

// However rough p is, what it is integrated with is smooth but for a few lines. So a box of the lobe's
// quadtree serves where its four children agree with it, and is split where they do not, or where a child is
// empty: its points lie beside p, and all of them may agree on what p never meets.
class PictureRule {
  public:
    // The lobe has no smooth form; it is kept as a reference.
    explicit PictureRule(const PlacedLobe& placed) {
        for (const LobeParameterization& span : placed.lobe->domains()) trees_.emplace_back(placed, span);
    }

    // Of f(h) times p, f giving Values<4> for any h of the surface's frame. `tolerance` is absolute, of every
    // value. Throws BakeCancelled soon after a stop is requested.
    template <class Function>
    Values<4> integrate(const Function& f, double tolerance, const std::stop_token& stop) const {
        Values<4> sum{};
        for (const PictureTree& tree : trees_)
            for (std::size_t i = 0; i < PictureTree::first_count(); ++i) {
                const Box box = PictureTree::first_box(i);
                const PictureTree::Cell& cell = tree.cell(i);
                add(sum, Over<Function>{tree, f, tolerance, stop}(cell, box, PictureTree::first_level,
                                                                  at(tree, cell, box, f)));
            }
        return sum;
    }

  private:
    static void add(Values<4>& sum, const Values<4>& values) {
        for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += values[i];
    }

    template <class Function>
    static Values<4> at(const PictureTree& tree, const PictureTree::Cell& cell, const Box& box,
                        const Function& f) {
        Values<4> sum{};
        if (cell.empty()) return sum;
        for (std::size_t i = 0; i < PictureTree::weights; ++i) {
            const Values<4> values = f(tree.direction(box, i));
            for (std::size_t c = 0; c < sum.size(); ++c) sum[c] += cell.weight[i] * values[c];
        }
        return sum;
    }

    template <class Function>
    struct Over {
        const PictureTree& tree;
        const Function& f;
        double tolerance;
        const std::stop_token& stop;

        // `coarse`: what the box itself gives.
        Values<4> operator()(const PictureTree::Cell& cell, const Box& box, int level,
                             const Values<4>& coarse) const {
            if (stop.stop_requested()) throw BakeCancelled();
            if (cell.children == 0) return coarse;
            std::array<Values<4>, 4> parts;
            Values<4> fine{};
            bool sparse = false, last = true;
            for (std::size_t i = 0; i < 4; ++i) {
                const PictureTree::Cell& child = tree.cell(cell.children + i);
                add(fine, parts[i] = at(tree, child, PictureTree::child_box(box, i), f));
                sparse = sparse || child.empty();
                last = last && child.children == 0;
            }
            double error = 0;
            for (std::size_t c = 0; c < fine.size(); ++c)
                error = std::fmax(error, std::fabs(fine[c] - coarse[c]));
            // Lines where f bends pass about 2^level boxes, and no more of those that are split further.
            const int lines = std::min(level, PictureTree::usual_level);
            if (last || (!sparse && error <= tolerance * std::exp2(-lines))) return fine;
            fine = {};
            for (std::size_t i = 0; i < 4; ++i)
                add(fine, (*this)(tree.cell(cell.children + i), PictureTree::child_box(box, i), level + 1,
                                  parts[i]));
            return fine;
        }
    };

    std::vector<PictureTree> trees_;
};

}  // namespace nacre
