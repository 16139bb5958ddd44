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

// Adaptive for smooth lobes (1e-8 of either), between the texels of a painted one (the whole as close, about
// 1e-5 of what k sees), on a dense fixed grid where a smooth lobe is modulated (about 1e-5, 1e-4 where texels
// are noise).
FacetIntegral integrate_facets(const Distribution& design, const FacetDistribution& distribution, dvec3 k,
                               std::stop_token stop = {});

// g(k) alone to an absolute tolerance, by the same adaptive quadrature; the facets of a lobe that has no
// smooth form are summed one by one.
class AdaptiveArea {
  public:
    AdaptiveArea(const FacetDistribution& distribution, double tolerance)
        : distribution_(distribution), tolerance_(tolerance), facets_(distribution.facets(0)) {}

    // Throws BakeCancelled soon after a stop is requested.
    double operator()(dvec3 k, const std::stop_token& stop) const;

  private:
    const FacetDistribution& distribution_;
    double tolerance_;
    std::vector<std::vector<Facet>> facets_;
};

// The integral of (k1.h)+ (k2.h)+ p(h) dh, in the same way.
class AdaptiveProduct {
  public:
    explicit AdaptiveProduct(const FacetDistribution& distribution)
        : distribution_(distribution), facets_(distribution.facets(0)) {}

    // To an absolute tolerance. Throws BakeCancelled soon after a stop is requested.
    double operator()(dvec3 k1, dvec3 k2, double tolerance, const std::stop_token& stop = {}) const;

  private:
    const FacetDistribution& distribution_;
    std::vector<std::vector<Facet>> facets_;
};

// A picture takes part.
bool holds_picture(const Distribution& design);

}  // namespace nacre
