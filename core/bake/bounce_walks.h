// What becomes of light that stays between the facets after its first bounce, by random walks.
#pragma once

#include <cstdint>
#include <vector>

#include "core/bake/workers.h"
#include "core/model/facet_distribution.h"
#include "core/model/shading.h"

namespace nacre {

// Light that went in from k1 and came out along k2.
struct BouncePair {
    dvec3 k1, k2;
};

struct BounceWalks {
    int walks = 0;                       // from directions strewn as their cosine about n
    std::vector<BouncePair> pairs = {};  // those that left after two bounces or more, F = 1
    double second = 1;                   // e2: which part of them left after the second
    // What light meets between its first bounce and its last, in the mean, each colour: the facets' tint,
    // where tints differ; Schlick's weight times that; F times that.
    dvec3 tint{1}, schlick{0}, fresnel{1};
};

// g from the finished tables of `shading`, below the horizon too: g(k) - g(-k) = H.k, H the mean of p.
double area_everywhere(const Shading<double>& shading, dvec3 mean, dvec3 k);

// At most so many walks, fewer where light bounces for long. `shading` holds the design with its tables of g
// and its layers; walks of another seed have nothing in common. The same for any number of threads. Throws
// BakeCancelled.
BounceWalks walk_bounces(const Shading<double>& shading, const FacetDistribution& distribution, int walks,
                         std::uint64_t seed, Workers& workers);

}  // namespace nacre
