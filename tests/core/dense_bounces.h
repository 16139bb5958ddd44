// All bounces between facets by a dense solution, for tests alone.
#pragma once

#include <vector>

#include "core/model/facet_distribution.h"

namespace nacre::test {

// The BRDF with F = 1 and the uncorrelated masking, between directions strewn evenly over the hemisphere:
// what leaves after the first bounce, and after all. Fine for lobes no narrower than the directions lie
// apart.
struct DenseBounces {
    std::vector<dvec3> k;
    std::vector<double> weight;  // c dk
    std::vector<double> first;   // rho[i * k.size() + j]
    std::vector<double> all;

    double more(std::size_t i, std::size_t j) const {
        return all[i * k.size() + j] - first[i * k.size() + j];
    }
};

DenseBounces dense_bounces(const FacetDistribution& distribution, int directions);

}  // namespace nacre::test
