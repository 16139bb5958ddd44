// Draws visible facets of a whole p at a cost that knows neither its pictures nor how many layers there are.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/model/facet_distribution.h"
#include "core/model/lobe_envelope.h"
#include "core/model/patch_tree.h"

namespace nacre {

class VisibleFacets {
  public:
    explicit VisibleFacets(std::vector<PlacedLobe> lobes);

    // A facet as k sees it, density (h.k)+ p(h)/g(k); nothing where g(k) = 0. |k| = 1.
    std::optional<dvec3> operator()(dvec3 k, Random& random) const;

    // h[i]: the same for k[i], 0 where there is nothing; faster than one by one, with other random numbers.
    void draw(std::span<const dvec3> k, Random& random, std::span<dvec3> h) const;

    // What facets are drawn from by rejection; g(k)/bound(k) of them are kept. No less than g(k).
    double bound(dvec3 k) const;

  private:
    struct Leaf {
        double mass = 0;  // with the lobe's scale
        std::size_t lobe = 0;
        FacetPatch patch;
    };

    std::vector<PatchBall> add_patches();
    double own_area(std::size_t own, dvec3 k) const;
    double own_area(dvec3 k) const;
    dvec3 draw_own(double left, dvec3 k, Random& random) const;
    bool draw_patch(const PatchDescent& descent, dvec3 k, Random& random, dvec3& h) const;
    template <std::size_t Most>
    void draw_some(std::span<const dvec3> k, Random& random, std::span<dvec3> h) const;
    dvec3 draw_exactly(dvec3 k, Random& random) const;

    std::vector<PlacedLobe> lobes_;
    std::vector<std::unique_ptr<const LobeEnvelope>>
        envelopes_;                       // of each lobe; null where it draws by itself
    std::vector<const PlacedLobe*> own_;  // those
    std::vector<Leaf> leaves_;            // as in the tree
    PatchTree tree_;
};

}  // namespace nacre
