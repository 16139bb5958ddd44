// Random walks of light between the facets of any p. They need no more of it than g and the facets that a
// direction sees.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "core/model/facet_distribution.h"
#include "core/model/masking/facet_walk.h"

namespace nacre {

// Uncorrelated, the partner of eq. 26: light that a facet sends up in the direction d leaves with the
// probability P(d) = min(1, N d.n/g(d)), otherwise it meets another facet as if it came from -d.
//
// Smith, the partner of the height-correlated masking (Heitz et al. 2016; Bitterli & d'Eon 2022): facets lie
// in the half space y >= 0 below the surface, and light that travels along w meets them g(-w)/N times per
// unit of length.
//
// What a facet does with light: mirrors it, or sends it out by Lambert's law about its normal.
enum class FacetScatter { mirror, matt };

// All walks of a set take their bounces together.
class FacetWalks {
  public:
    struct Walk {
        dvec3 view;         // the direction that the light comes from
        double depth;       // below the surface; Smith's alone
        dvec3 weight;       // of each colour, what was left at its bounces
        std::size_t index;  // in the list of enter()
    };

    // g(k) of directions above and below the horizon. N: <n.h> as the masking takes it.
    using Area = std::function<double(dvec3)>;

    FacetWalks(const FacetDistribution& distribution, FacetWalk kind, double N, Area g,
               FacetScatter scatter = FacetScatter::mirror);

    // Light from each of these directions, of weight 1, has gone in. They are unit vectors above the horizon.
    void enter(std::span<const dvec3> k1, Random& random);

    // Those that are still between the facets.
    const std::vector<Walk>& inside() const { return walks_; }

    // One bounce of all of them. reflect(walk, h): at a facet of normal h, where the weight may change;
    // leave(walk, k2): the light is outside, on its way along k2. Light that sees no facet is lost.
    using Reflect = std::function<void(Walk&, dvec3 h)>;
    using Leave = std::function<void(const Walk&, dvec3 k2)>;
    void bounce(Random& random, const Reflect& reflect, const Leave& leave);

    // The chance, per steradian and over k2.n, that the next bounce of a walk sends its light along k2 to the
    // outside, as a facet of density p(h) would: h halfway between walk.view and k2. Its mean over the walks
    // is rho of that order.
    double next_event(const Walk& walk, dvec3 k2, double p) const;

    // The chance, over k2.n, that light of a walk which a facet sends along k2 leaves by it.
    double way_out(const Walk& walk, dvec3 k2) const;

  private:
    dvec3 scattered(dvec3 view, dvec3 h, Random& random) const;
    bool leaves(Walk& walk, dvec3 d, Random& random) const;

    const FacetDistribution& distribution_;
    FacetWalk kind_;
    double N_;
    Area g_;
    FacetScatter scatter_;
    std::vector<Walk> walks_;
    std::vector<dvec3> views_, facets_;
};

}  // namespace nacre
