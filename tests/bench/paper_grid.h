// The paper's table (Ashikhmin 2000, sec. 5.2): nodes evenly over theta and phi, bilinear between them. Of a
// p with two mirror planes through the axes, hence of a quarter of the hemisphere.
#pragma once

#include <vector>

#include "core/model/facet_distribution.h"

namespace nacre::bench {

class PaperGrid {
  public:
    PaperGrid(int polar, int azimuths) : polar_(polar), azimuths_(azimuths) {}

    std::vector<dvec3> directions() const;  // of the nodes, above the horizon or on it

    // The table of g, exact at the nodes.
    void fill(const FacetDistribution& facets);
    double at(dvec3 k) const;

    int nodes() const { return polar_ * azimuths_; }

  private:
    int polar_, azimuths_;
    std::vector<double> values_;
};

}  // namespace nacre::bench
