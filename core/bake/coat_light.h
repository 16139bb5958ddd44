// Light between a coat and what lies beneath it; see shaders/shared/coat.glsl.
#pragma once

#include <vector>

#include "core/bake/tables.h"
#include "core/bake/workers.h"

namespace nacre {

// A direction inside the coat by one number and an azimuth: 1 at n, the root of the cosine outside while
// light along it can leave, 0 at the critical angle, and below 0 beyond that, -1 along the border.
dvec3 inside_direction(double at, dvec2 azimuth, double ior);

// How much light along k', inside, leaves through the coat in the end, each colour: without what has been
// back and forth, then that.
struct CoatLight {
    dvec3 once{0}, again{0};

    dvec3 whole() const { return once + again; }
};

class CoatLightIntegral {
  public:
    // `shading` holds the finished tables of what lies beneath and the coat's own albedo, but counts as
    // uncoated; it and `p` are kept as references. `facets` of a lobe and `cosines` directions make a sum.
    CoatLightIntegral(const FacetDistribution& p, const Shading<double>& shading, std::size_t facets,
                      int cosines);

    // Finds what leaves along nodes of (at, azimuth), so many each, to be read between them.
    void solve(int nodes, const std::vector<dvec2>& azimuths, Workers& workers);

    // Once solved.
    CoatLight operator()(dvec3 k) const;

  private:
    using Direction = Shading<double>::Direction;
    // Where a direction lies between the nodes.
    struct Spot {
        std::size_t node[4];
        double weight[4];
    };

    // visit(k2, part) for the light from k that the facets send to k2: rho c2 dk2.
    template <class Visit>
    void scatter(dvec3 k, const Visit& visit) const;
    Direction beneath(dvec3 k) const;
    dvec3 through(dvec3 k) const;   // t, of light that leaves along k
    dvec3 returned(dvec3 k) const;  // f: what the coat sends back
    Spot spot(dvec3 k) const;
    dvec3 read(const Spot& spot) const;

    const Shading<double>& shading_;
    std::vector<Facet> facets_;
    std::vector<Direction> ends_;
    int nodes_ = 0;  // from -1 to 1
    int rows_ = 1;
    std::vector<dvec3> whole_;  // u at the nodes, row by row
};

}  // namespace nacre
