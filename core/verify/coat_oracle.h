// A coat over facets that are evaluated without tables; see shaders/shared/coat.glsl.
#pragma once

#include <memory>

#include "core/bake/tables.h"
#include "core/design/design.h"

namespace nacre {

// Its own highlight, and what it lets through, by quadrature to 1e-6. What has been back and forth beneath it
// comes from the tables of a final bake.
class CoatOracle {
  public:
    // `design` has a coat. Throws what bake() throws.
    explicit CoatOracle(const Design& design);

    dvec3 inside(dvec3 k) const;
    dvec3 passage(dvec3 k1, dvec3 k2) const;     // of what leaves from inside(k1) to inside(k2)
    dvec3 reflection(dvec3 k1, dvec3 k2) const;  // 1/sr: what the coat adds to that

    // Of one direction, with what the tables do not hold.
    Shading<double>::Direction direction(dvec3 k) const;

  private:
    std::shared_ptr<const Tables> tables_;
};

}  // namespace nacre
