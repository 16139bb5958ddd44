// g(k) as the plain sum over facets of (k.h)+ mass: the loop that the moment pyramid is compared with.
#pragma once

#include <span>
#include <vector>

#include "core/model/lobe.h"

namespace nacre::bench {

// Real is float or double: what the facets and the products are in; the sum of all blocks is in double.
template <class Real>
class PlainArea {
  public:
    explicit PlainArea(const std::vector<Facet>& facets);

    void operator()(std::span<const dvec3> k, std::span<double> g) const;

  private:
    std::vector<Real> x_, y_, z_;  // mass times h; padded with zeros to whole blocks
};

}  // namespace nacre::bench
