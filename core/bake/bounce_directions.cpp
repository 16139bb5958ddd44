#include "core/bake/bounce_directions.h"

#include <array>
#include <cmath>
#include <numbers>

namespace nacre {
namespace {

using std::numbers::pi;

dvec3 from_square(double u, double v) {
    const double r = std::sqrt(u), phi = 2 * pi * v;
    return {r * std::cos(phi), r * std::sin(phi), std::sqrt(1 - u)};
}

}  // namespace

// A spiral over the unit disk (Vogel 1979).
std::vector<dvec3> even_directions(int count) {
    std::vector<dvec3> directions;
    for (int i = 0; i < count; ++i) {
        const double r2 = (i + 0.5) / count, phi = 2 * pi * std::fmod(i * std::numbers::phi, 1.0);
        const double r = std::sqrt(r2);
        directions.push_back({r * std::cos(phi), r * std::sin(phi), std::sqrt(1 - r2)});
    }
    return directions;
}

std::vector<dvec3> watched_directions(int count) {
    constexpr int azimuths = 256;
    std::vector<dvec3> directions = even_directions(count);
    for (const double c : {0.0, 0.003, 0.01, 0.03, 0.1})
        for (int i = 0; i < azimuths; ++i) {
            const double phi = 2 * pi * (i + 0.5) / azimuths, r = std::sqrt(1 - c * c);
            directions.push_back({r * std::cos(phi), r * std::sin(phi), c});
        }
    return directions;
}

// Roberts 2018, the R4 sequence.
std::vector<BouncePair> even_pairs(std::size_t count) {
    constexpr double root = 1.1673039782614187;  // x^5 = x + 1
    std::array<double, 4> step{}, at{0.5, 0.5, 0.5, 0.5};
    for (std::size_t i = 0; i < 4; ++i) step[i] = std::pow(root, -(static_cast<double>(i) + 1));
    std::vector<BouncePair> pairs;
    for (std::size_t n = 0; n < count; ++n) {
        for (std::size_t i = 0; i < 4; ++i) at[i] = std::fmod(at[i] + step[i], 1.0);
        pairs.push_back({from_square(at[0], at[1]), from_square(at[2], at[3])});
    }
    return pairs;
}

}  // namespace nacre
