// Integrals over the facets of a design from p alone, by a quadrature that shares nothing with mass() and
// area().
#pragma once

#include <stop_token>

#include "core/model/facet_distribution.h"

namespace nacre {

struct FacetIntegral {
    double whole = 0;    // integral of p(h) dh
    double visible = 0;  // integral of (k.h)+ p(h) dh
};

// Adaptive for smooth lobes (1e-8 of either), a dense fixed grid where a picture takes part (about 1e-3).
FacetIntegral integrate_facets(const Distribution& design, const FacetDistribution& distribution, dvec3 k,
                               std::stop_token stop = {});

// A picture takes part.
bool holds_picture(const Distribution& design);

}  // namespace nacre
