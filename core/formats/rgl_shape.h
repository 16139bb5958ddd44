// What a measured material's tables hold of a design: a normal distribution that has the shape of the whole
// BRDF over half vectors, and what the BRDF is over it.
#pragma once

#include <vector>

#include "core/bake/tables.h"

namespace nacre {

class RglShape {
  public:
    // Keeps `tables` as a reference.
    explicit RglShape(const Tables& tables);

    using Direction = Shading<double>::Direction;
    Direction direction(dvec3 k) const { return tables_.shading.direction(k); }

    // The facets that the outermost highlight comes from (p/N, or the coat's own), and for everything else as
    // many as would mirror as much; 1/sr.
    double ndf(dvec3 m) const { return facets(m) + others_at(m); }
    // g/N; k.z >= 0.
    double sigma(dvec3 k) const;
    // rho cos(theta_o)/ndf(m), m half way between; 0 where k2 is not above the horizon.
    dvec3 over_ndf(const Direction& from, dvec3 k2, dvec3 m) const;

  private:
    // Of `from` and `to`, whose half vector is m.
    struct Pair {
        dvec3 per_facet;  // what the outermost highlight is for each 1/sr of facets
        dvec3 others;     // everything besides that highlight, 1/sr
    };
    Pair pair(const Direction& from, const Direction& to, dvec3 m) const;
    double facets(dvec3 m) const;
    double others_at(dvec3 m) const;
    double other_facets(dvec3 m) const;

    const Tables& tables_;
    bool coated_;
    int columns_, rows_;          // of others_
    std::vector<double> others_;  // empty where there are none
};

}  // namespace nacre
