// The paper's table of g (Ashikhmin 2000, sec. 5.2) of a p with two mirror planes through the axes: a quarter
// of the plain grid.
#pragma once

#include <vector>

#include "core/model/facet_distribution.h"
#include "core/study/plain_grid.h"

namespace nacre::bench {

class PaperGrid {
  public:
    // So many azimuths of the quarter, both ends included.
    PaperGrid(int polar, int azimuths) : grid_(polar, 4 * (azimuths - 1), {Symmetry::quarter, 0}) {}

    std::vector<dvec3> directions() const {  // of the nodes
        std::vector<dvec3> all;
        for (int node = 0; node < grid_.size(); ++node) all.push_back(grid_.direction(node));
        return all;
    }

    // Exact at the nodes.
    void fill(const FacetDistribution& facets) {
        values_.clear();
        for (const dvec3 k : directions()) values_.push_back(static_cast<float>(facets.area(k).g));
    }
    double at(dvec3 k) const { return grid_.value(values_, k); }

    int nodes() const { return grid_.size(); }

  private:
    PlainGrid grid_;
    std::vector<float> values_;
};

}  // namespace nacre::bench
