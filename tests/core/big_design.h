// Designs of many painted and modulated layers.
#pragma once

#include <cmath>
#include <string>

#include "tests/core/designs.h"

namespace nacre::test {

// Hills, noise, a sparse strew of texels and rings, in turn.
inline Picture random_picture(int side, int kind, Random& random) {
    struct Hill {
        double x, y, size, height;
    };
    std::vector<Hill> hills;
    for (int i = 0; i < 24; ++i)
        hills.push_back({2 * uniform_random(random) - 1, 2 * uniform_random(random) - 1,
                         0.03 + 0.3 * std::pow(uniform_random(random), 2), uniform_random(random)});
    return picture_of(side, [&](double x, double y) {
        double sum = 0;
        if (kind % 4 == 1) return uniform_random(random);
        if (kind % 4 == 2) return uniform_random(random) < 1e-2 ? 100 * uniform_random(random) : 0;
        for (const Hill& hill : hills) {
            const double away = std::hypot(x - hill.x, y - hill.y);
            sum += kind % 4 == 0 ? hill.height * std::exp(-std::pow(away / hill.size, 2))
                                 : (std::fabs(away - hill.size) < 0.02 ? 1 : 0);
        }
        return sum;
    });
}

// Every layer painted and modulated by pictures of `side` texels a side, each leaning elsewhere.
inline Design big_design(int layers, int side) {
    Random random(5);
    Design design;
    design.distribution.layers.clear();
    for (int i = 0; i < layers; ++i) {
        Layer layer;
        layer.lobe = PaintedLobe{random_picture(side, i, random)};
        layer.modulation = Modulation{random_picture(side, 0, random), 0.5 + 0.5 * uniform_random(random)};
        layer.weight = 0.1 + uniform_random(random);
        layer.tilt = 40 * uniform_random(random);
        layer.azimuth = 360 * uniform_random(random);
        layer.rotation = 360 * uniform_random(random);
        design.distribution.layers.push_back(layer);
    }
    design.fresnel = SchlickFresnel{};
    design.diffuse = CoupledDiffuse{};
    return design;
}

}  // namespace nacre::test
