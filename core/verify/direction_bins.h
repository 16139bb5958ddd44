// The hemisphere in bins that are about equally likely.
#pragma once

#include <cstddef>
#include <vector>

#include "core/model/lobe.h"

namespace nacre {

// A direction and its share of all samples.
struct DirectionShare {
    dvec3 k;
    double share;
};

class DirectionBins {
  public:
    // Halves the shares over and over, across the wider extent on the disk of x and y, into at most `most`
    // bins of 32 shares or more.
    DirectionBins(std::vector<DirectionShare> shares, int most);

    std::size_t count() const { return share_.size(); }
    std::size_t index(dvec3 k) const;
    double share(std::size_t bin) const { return share_[bin]; }

    // Of share(): as if its parts had been drawn at random; evenly spaced parts have less.
    double variance(std::size_t bin) const { return variance_[bin]; }

  private:
    struct Node {
        int axis = 0;
        double at = 0;
        int below = -1, above = -1;  // nodes
        std::size_t bin = 0;         // where there are none
    };

    int part(DirectionShare* begin, DirectionShare* end, int most);

    std::vector<Node> nodes_;
    std::vector<double> share_, variance_;
};

}  // namespace nacre
