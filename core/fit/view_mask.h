// The design's own visibility as view weights of lobes use it.
#pragma once

#include <vector>

#include "core/bake/tables.h"

namespace nacre {

struct MaskValue {
    double value = 0;
    dvec3 by_k{0};       // d value/d k
    double by_blur = 0;  // d value/d blur
};

// P(k) of the design, from a table of P(k)/(n.k) over ((kx, ky)/(1 + kz)), which is bounded.
class ViewMask {
  public:
    explicit ViewMask(const Tables& tables);

    // P(k)/(n.k) exactly as the tables have it; k.z > 0.
    static double visibility_part(const Tables& tables, dvec3 k);

    // The cosine falls to 0 over `blur` about the horizon: a lobe mirrors a view into many directions, of
    // which k is the middle.
    MaskValue operator()(dvec3 k, double blur) const;

    double part(dvec3 k) const { return look_up(k).value; }  // P(k)/(n.k)

  private:
    struct Part {
        double value;
        dvec2 by_place;
    };
    Part look_up(dvec3 k) const;

    std::vector<double> part_;
};

// The direction at a texel of a square of `side` texels over ((kx, ky)/(1 + kz)), whose outer texel centres
// lie on the horizon; beyond it is the horizon's nearest.
dvec3 texel_direction(int column, int row, int side);

// Where k lies in that square: texel centres are whole numbers.
dvec2 texel_place(dvec3 k, int side);

}  // namespace nacre
