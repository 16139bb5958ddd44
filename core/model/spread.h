// The spread of a small patch of facets about its mean direction.
#pragma once

#include "core/model/lobe.h"

namespace nacre {

// Along a direction k at right angles to h a small tent about h, or anything with its second moments, spreads
// as a tent of half-width a: a^2 = k.(S k).
struct Spread {
    double xx = 0, yy = 0, zz = 0, xy = 0, xz = 0, yz = 0;

    Spread& operator+=(const Spread& other);
    friend Spread operator*(double factor, Spread spread);

    // The largest a, of a spread along two directions.
    double half_width() const;
};

// The same patch after a rotation.
Spread rotated(const Spread& spread, const glm::dmat3& rotation);

// S = u u' + v v' + ...: of tents with half-widths u and v.
Spread spread_along(dvec3 u);

// Of tents on the disk.
Spread spread_on_disk(dvec2 at, double reach);

}  // namespace nacre
