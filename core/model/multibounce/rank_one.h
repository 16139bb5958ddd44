#pragma once

#include <tuple>

namespace nacre {

// Kulla and Conty 2017; for F = 1 eq. 28 of Ashikhmin et al. 2000.
struct RankOneMultibounce {
    bool operator==(const RankOneMultibounce&) const = default;

    static constexpr const char* name = "rank_one";
    static constexpr const char* label = "Even";
    static constexpr const char* explanation =
        "Light that bounces on comes back spread evenly: (1 \u2212 E1)(1 \u2212 E2)/(\u03c0(1 \u2212 <E>)) "
        "(Kulla and Conty 2017). True to round highlights.";
    static constexpr int file_version = 2;
    static constexpr auto parameters() { return std::tuple{}; }

    static constexpr const char* rest_formula = "e = max(0, 1 - E)";
    static constexpr const char* formula = "M = bounce_even e1 e2";
    static constexpr bool bounces = true;
    static constexpr bool fitted = false;
};

}  // namespace nacre
