#pragma once

#include <tuple>

#include "core/model/masking/facet_walk.h"
#include "core/model/masking/masking_bends.h"

namespace nacre {

// Ashikhmin et al. 2000, eq. 26.
struct UncorrelatedMasking {
    bool operator==(const UncorrelatedMasking&) const = default;

    static constexpr const char* name = "uncorrelated";
    static constexpr const char* label = "Uncorrelated";
    static constexpr const char* explanation = "Light and eye are hidden independently: P1 P2 (eq. 26).";
    static constexpr const char* compared_label = "Same p, uncorrelated";
    static constexpr const char* citation = "Ashikhmin, Premoze and Shirley 2000, eq. 26";
    static constexpr const char* formula = "V = N/(G1 G2)";
    static constexpr const char* part = nullptr;
    static constexpr MaskingBends bends = MaskingBends::none;
    static constexpr FacetWalk walk = FacetWalk::uncorrelated;
    static constexpr auto parameters() { return std::tuple{}; }

    double shader_width() const { return 1; }  // read by no one
};

}  // namespace nacre
