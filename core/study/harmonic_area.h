// g as a sum of spherical harmonics. g(k) is the integral of max(0, h.k) p(h), a convolution of p with the
// clamped cosine, so it multiplies each harmonic of p by a number of its degree.
#pragma once

#include <memory>
#include <stop_token>
#include <vector>

#include "core/model/facet_distribution.h"
#include "core/study/spherical_harmonics.h"

namespace nacre {

class HarmonicArea {
  public:
    // Harmonics of p up to `degree` by quadrature in the lobes' own coordinates; with `round`, p depends on
    // theta alone. Throws BakeCancelled soon after a stop is requested.
    HarmonicArea(const FacetDistribution& distribution, int degree, bool round, const std::stop_token& stop);

    double operator()(dvec3 k) const;

    std::size_t size() const { return coefficients_.size(); }

    // The part of g's norm over the sphere that the upper half of the degrees holds: what a sum to half of
    // them leaves out.
    double upper_half() const;

  private:
    void add(const Facet& facet);

    HarmonicBasis basis_;
    std::vector<double> coefficients_;
    std::vector<double> values_;
};

}  // namespace nacre
