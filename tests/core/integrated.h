// Albedos by summing a BRDF over directions.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/bake/brdf.h"
#include "tests/core/random_directions.h"

namespace nacre::test {

// Integral of rho(k, k') c' dk', each colour: midpoints of theta and phi.
inline dvec3 integrated(const Brdf& brdf, dvec3 k, Term term) {
    using std::numbers::pi;
    constexpr int polar_steps = 240, azimuths = 480;
    dvec3 sum{0};
    for (int i = 0; i < polar_steps; ++i) {
        const double theta = 0.5 * pi * (i + 0.5) / polar_steps;
        dvec3 ring{0};
        for (int j = 0; j < azimuths; ++j)
            ring += brdf.evaluate(k, polar(std::cos(theta), 2 * pi * (j + 0.5) / azimuths), term);
        sum += ring * (std::cos(theta) * std::sin(theta) * (0.5 * pi / polar_steps) * (2 * pi / azimuths));
    }
    return sum;
}

inline double apart(dvec3 a, dvec3 b) {
    const dvec3 d = glm::abs(a - b);
    return std::max({d.x, d.y, d.z});
}

}  // namespace nacre::test
