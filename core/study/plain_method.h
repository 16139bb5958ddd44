// The paper's method, for comparison: g on a plain grid of 200 directions and eq. 26 without
// clamp, R by plain Monte Carlo (Ashikhmin 2000, sec. 5).
#pragma once

#include <span>
#include <stop_token>

#include "core/bake/tables.h"
#include "core/study/grid_table.h"

namespace nacre {

struct DirectionPair {
    dvec3 k1, k2;
};

class PlainMethod {
  public:
    // The nodes hold exact g, which is more than the paper has. Reads p from `tables`, which must outlive
    // this.
    PlainMethod(const Tables& tables, const std::stop_token& stop);

    double area(dvec3 k) const { return grid_.area(k); }

    // p N/(4 g1 g2), F = 1; what the arithmetic makes of it.
    double specular(dvec3 k1, dvec3 k2) const;

    // R with F = 1, the mean of pi rho over `samples` directions drawn by the cosine.
    double albedo(dvec3 k, int samples, Random& random) const;

  private:
    const Tables& tables_;
    GridTable grid_;
};

struct PlainMethodErrors {
    double area = 0;    // of g, relative; see area_error(), without clamp
    double albedo = 0;  // of R, absolute; against the bake's rule for the same form, without clamp
    int unsound = 0;    // pairs with c of 1e-6 and more whose rho is not finite or is negative
};

PlainMethodErrors measure_plain_method(const Tables& tables, std::span<const DirectionPair> pairs,
                                       std::span<const dvec3> area_probes,
                                       std::span<const dvec3> albedo_probes, const std::stop_token& stop);

}  // namespace nacre
