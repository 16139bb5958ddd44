#pragma once

#include <tuple>

namespace nacre {

struct NoMultibounce {
    bool operator==(const NoMultibounce&) const = default;

    static constexpr const char* name = "none";
    static constexpr const char* label = "None";
    static constexpr const char* explanation =
        "Light that hits a second facet is lost: rough metals come out dark (eq. 26 alone).";
    static constexpr auto parameters() { return std::tuple{}; }

    static constexpr const char* rest_formula = "";
    static constexpr const char* formula = "";
    static constexpr bool bounces = false;
    static constexpr bool fitted = false;
};

}  // namespace nacre
