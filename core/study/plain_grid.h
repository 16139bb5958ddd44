// A plain grid of directions, even in theta and in azimuth, with bilinear look-up: how the paper stores g and
// R (Ashikhmin 2000, sec. 5.2).
#pragma once

#include <string>
#include <vector>

#include "core/bake/symmetry.h"
#include "core/model/lobe.h"

namespace nacre {

class PlainGrid {
  public:
    // `polar` nodes from the normal to the horizon, both included, by `azimuths` round the circle, a multiple
    // of 4. Kept are those that p's symmetry leaves: all, a half or a quarter with both ends, or one azimuth.
    PlainGrid(int polar, int azimuths, DistributionSymmetry symmetry);

    int size() const { return polar_ * rows_; }
    dvec3 direction(int node) const;

    // The nodes' values in between; k.z >= 0.
    double value(const std::vector<float>& nodes, dvec3 k) const;

    // "60 of 10 x 20 nodes".
    std::string label() const;

  private:
    double folded(double azimuth) const;  // radians from the axis, into the kept range

    int polar_, azimuths_;
    int rows_;  // kept azimuths
    Symmetry symmetry_;
    double axis_;  // radians
};

}  // namespace nacre
