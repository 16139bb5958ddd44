// Directions above the horizon, grazing ones among them.
#pragma once

#include <cmath>
#include <numbers>

#include "core/model/lobe.h"

namespace nacre::test {

inline dvec3 polar(double cosine, double phi) {
    const double sine = std::sqrt(std::fmax(1 - cosine * cosine, 0.0));
    return glm::normalize(dvec3{sine * std::cos(phi), sine * std::sin(phi), cosine});
}

// One in three has a cosine between 1e-5 and 1, evenly in its logarithm.
inline dvec3 random_direction(Random& random) {
    const double phi = 2 * std::numbers::pi * uniform_random(random);
    const double u = uniform_random(random);
    const bool grazing = uniform_random(random) < 1.0 / 3;
    return polar(grazing ? std::pow(10, -5 * u) : std::fmax(u, 1e-5), phi);
}

}  // namespace nacre::test
