// g(k) as the plain sum over facets of (k.h)+ mass: the loop that the moment pyramid is compared with.
#pragma once

#include <span>
#include <vector>

#include "core/model/lobe.h"

namespace nacre::bench {

class PlainArea {
  public:
    explicit PlainArea(const std::vector<Facet>& facets);

    void operator()(std::span<const dvec3> k, std::span<double> g) const;

  private:
    std::vector<float> x_, y_, z_;  // mass times h; padded with zeros to whole blocks
};

}  // namespace nacre::bench
