// Directions as the lines that nacre-cli reads.
#pragma once

#include <fmt/core.h>

#include <cmath>
#include <glm/glm.hpp>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace nacre::test {

inline std::string line_of(glm::dvec3 k) { return fmt::format("{:.17g} {:.17g} {:.17g}", k.x, k.y, k.z); }

inline glm::dvec3 at_height(double c, double phi) {
    const double sine = std::sqrt((1 - c) * (1 + c));
    return {sine * std::cos(phi), sine * std::sin(phi), c};
}

// Over the hemisphere, a third of them close to the horizon: c down to 1e-5.
inline std::vector<glm::dvec3> test_directions(int count, unsigned seed = 1) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> unit(0, 1);
    std::vector<glm::dvec3> directions;
    for (int i = 0; i < count; ++i) {
        const double c = i == 0 ? 1e-5 : i % 3 == 0 ? std::pow(10, -5 * unit(random)) : unit(random);
        directions.push_back(at_height(c, 2 * std::numbers::pi * unit(random)));
    }
    return directions;
}

inline std::string lines_of(const std::vector<glm::dvec3>& directions) {
    std::string text;
    for (const glm::dvec3 k : directions) text += line_of(k) + "\n";
    return text;
}

}  // namespace nacre::test
