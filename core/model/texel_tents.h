// What each texel of a picture adds to integrals over the disk.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <vector>

#include "core/model/disk.h"
#include "core/model/lobe.h"

namespace nacre {

// Places all over the disk with their shares of solid angle, at which a smooth function times a picture of so
// many texels a side is integrated, or times two such pictures; 0 where there is no second.
void visit_disk(int side, int other_side, const std::function<void(dvec2 at, double solid_angle)>& visit);

// A picture that is bilinear between texels' middles, and flat beyond the outermost, is the sum of its values
// times their tents: 1 at the texel's middle, straight down to 0 at its neighbours'. Tents end at the rim.
class TexelTents {
  public:
    explicit TexelTents(int side);

    // Tents times another bilinear picture of so many texels a side, at a place of the disk.
    using FactorAt = std::function<double(dvec2 at)>;
    TexelTents(int side, const FactorAt& factor, int factor_side);

    // Integral of the tent, and of h over the tent divided by that: at once inside the sphere.
    Facet operator()(int row, int column) const;
    double weight(int row, int column) const { return (*this)(row, column).mass; }

    // So far a tent reaches from its middle, as a part of the disk's radius.
    double reach() const { return 2.0 / side_; }

  private:
    struct Rim;
    static std::shared_ptr<const Rim> rim_of(int side);

    int side_;
    std::shared_ptr<const Rim> rim_;
    std::shared_ptr<const std::vector<std::array<float, 3>>> all_;  // with a factor: centre and weight
};

// Along a direction k at right angles to h a small tent about h, or anything with its second moments, spreads
// as a tent of half-width a: a^2 = k.(S k).
struct Spread {
    double xx = 0, yy = 0, zz = 0, xy = 0, xz = 0, yz = 0;

    Spread& operator+=(const Spread& other);

    // The largest a, of a spread along two directions.
    double half_width() const;
};

// S = u u' + v v' + ...: of tents with half-widths u and v.
Spread spread_along(dvec3 u);

// Of tents on the disk.
Spread spread_on_disk(dvec2 at, double reach);

}  // namespace nacre
