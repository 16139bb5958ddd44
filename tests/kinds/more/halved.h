#pragma once

#include <tuple>

#include "core/model/masking/facet_walk.h"
#include "core/model/masking/masking_bends.h"

namespace nacre {

// Half of what the uncorrelated model lets through.
struct HalvedMasking {
    bool operator==(const HalvedMasking&) const = default;

    static constexpr const char* name = "halved";
    static constexpr const char* label = "Halved";
    static constexpr const char* explanation = "Half of P1 P2.";
    static constexpr const char* compared_label = "Same p, halved";
    static constexpr const char* citation = "tests/kinds";
    static constexpr const char* formula = "V = N/(G1 G2)/2";
    static constexpr const char* part = nullptr;
    static constexpr MaskingBends bends = MaskingBends::none;
    static constexpr FacetWalk walk = FacetWalk::uncorrelated;
    static constexpr auto parameters() { return std::tuple{}; }
    double shader_width() const { return 1; }
};

}  // namespace nacre
