// The ways in which facets send light from one direction on, by p itself: mirrored, or turned about n before
// or after; under a coat those of the facets beneath it, and that of the coat's own.
#pragma once

#include <vector>

#include "core/bake/mirror_ways.h"
#include "core/bake/tables.h"

namespace nacre {

struct FacetWay {
    MirrorWay way;
    const FacetDistribution* distribution;
    bool refracts;
    dvec3 k1;  // as these facets see it
    double g;

    // Of k2 by visible facets, 1/sr.
    double density(const Shading<double>& shading, dvec3 k2) const;

    // k2 of a facet; not above the horizon where the light does not leave.
    dvec3 end(const Shading<double>& shading, dvec3 h) const;
};

// Those that are gone and find facets. `tables` is kept.
std::vector<FacetWay> facet_ways(const Tables& tables, dvec3 k1);

}  // namespace nacre
