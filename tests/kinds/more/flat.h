#pragma once

#include <tuple>

namespace nacre {

// As rank_one.
struct FlatMultibounce {
    bool operator==(const FlatMultibounce&) const = default;

    static constexpr const char* name = "flat";
    static constexpr const char* label = "Flat";
    static constexpr const char* explanation = "Spread evenly.";
    static constexpr int file_version = 2;
    static constexpr auto parameters() { return std::tuple{}; }

    static constexpr const char* rest_formula = "e = max(0, 1 - E)";
    static constexpr const char* formula = "M = bounce_even e1 e2 1";
    static constexpr bool bounces = true;
    static constexpr bool fitted = false;
};

}  // namespace nacre
