// Samples visible normals for one direction.
#pragma once

#include <vector>

#include "core/model/facet_distribution.h"

namespace nacre {

class VisibleSampler {
  public:
    // `lobes` is kept as a reference.
    VisibleSampler(const std::vector<PlacedLobe>& lobes, dvec3 k);

    double area() const { return area_; }  // g(k) of these lobes

    // Density (h.k)+ p(h)/g(k); area() > 0.
    dvec3 operator()(Random& random) const;

  private:
    const std::vector<PlacedLobe>& lobes_;
    dvec3 k_;
    std::vector<double> parts_;  // of area_, each lobe's
    double area_ = 0;
};

}  // namespace nacre
