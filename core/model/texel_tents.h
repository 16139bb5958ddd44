// What each texel of a picture adds to integrals over the disk.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <vector>

#include "core/model/disk.h"
#include "core/model/lobe.h"

namespace nacre {

// A picture that is bilinear between texels' middles, and flat beyond the outermost, is the sum of its values
// times their tents: 1 at the texel's middle, straight down to 0 at its neighbours'. Tents end at the rim.
class TexelTents {
  public:
    explicit TexelTents(int side);

    // Tents times another bilinear picture, a function of the place on the disk.
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

}  // namespace nacre
