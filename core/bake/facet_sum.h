// R(k) over a list of facets, many side by side in vectors as wide as the processor has.
#pragma once

#include <vector>

#include "core/model/lobe.h"
#include "core/model/quadrature.h"
#include "core/model/shading.h"

namespace nacre {

// R with F = 1, then with one or three Fresnel factors (Schlick's weight, or the design's exact F).
using AlbedoValues = Values<4>;

// Facets in columns: unit normals and masses p dh.
class FacetColumns {
  public:
    void add(const Facet& facet) {
        x_.push_back(facet.h.x);
        y_.push_back(facet.h.y);
        z_.push_back(facet.h.z);
        mass_.push_back(facet.mass);
    }

    std::size_t size() const { return x_.size(); }
    const double* x() const { return x_.data(); }
    const double* y() const { return y_.data(); }
    const double* z() const { return z_.data(); }
    const double* mass() const { return mass_.data(); }

  private:
    std::vector<double> x_, y_, z_, mass_;
};

// What these facets add to R(k1), g(k1) = g1, g(k2) from the tables of `shading`; see Shading::facet_albedo.
// The same for any number of threads; the order of the sum follows the width of the vectors.
AlbedoValues sum_albedo(const Shading<double>& shading, dvec3 k1, double g1, int channels,
                        const FacetColumns& facets);

}  // namespace nacre
