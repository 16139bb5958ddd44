// What tables are judged by that took part in no bake: directions of their own, and random designs.
#pragma once

#include "core/bake/tables.h"
#include "core/design/design.h"

namespace nacre::test {

// So many, every fourth within 3 degrees of the horizon, some of those far closer.
std::vector<dvec3> held_out_directions(int count, unsigned seed);

// One to four lobes of any width that lean by up to 60 degrees, in a p without symmetry.
Design random_mixture(unsigned seed);

// The worst of some directions.
struct HeldOutError {
    double worst = 0;
    dvec3 at{0, 0, 1};
};

// Of the tables' g against p itself.
HeldOutError held_out_area(const Tables& tables, const std::vector<dvec3>& directions);

// Of the tables' R: the bake's quadrature at a fortieth of the tolerance says where it may be worst, adaptive
// integration what it is there, unless a picture takes part, whose facets the quadrature sums.
HeldOutError held_out_albedo(const Design& design, const Tables& tables,
                             const std::vector<dvec3>& directions);

}  // namespace nacre::test
