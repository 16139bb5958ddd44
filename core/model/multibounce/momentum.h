#pragma once

#include <tuple>

namespace nacre {

// Tables over the sum and the difference of both directions along the surface, fitted to random walks between
// the facets.
struct MomentumMultibounce {
    bool operator==(const MomentumMultibounce&) const = default;

    static constexpr const char* name = "momentum";
    static constexpr const char* label = "Directed";
    static constexpr const char* explanation =
        "Light that bounces on comes back where the facets send it: brushed metal keeps its line, grooves "
        "send "
        "light back to where it came from. Tables fitted to random walks between the facets; a second or two "
        "until they are ready.";
    static constexpr int file_version = 2;
    static constexpr auto parameters() { return std::tuple{}; }

    static constexpr const char* rest_formula =
        "a = amplitude(2 x/(1 + z), 2 y/(1 + z)); m = a brought(v, rho); e = max(0, 1 - E - m)";
    static constexpr const char* formula =
        "M = a1 a2 (sum(k1 + k2) + difference(k1 - k2)) + bounce_even e1 e2";
    static constexpr bool bounces = true;
    static constexpr bool fitted = true;
};

}  // namespace nacre
