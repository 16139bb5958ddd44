#pragma once

#include <tuple>

#include "core/model/kinds/extreme_claims.h"
#include "core/model/masking/facet_walk.h"
#include "core/model/masking/masking_bends.h"

namespace nacre {

// Heitz 2014, eq. 99.
struct SmithCorrelatedMasking {
    bool operator==(const SmithCorrelatedMasking&) const = default;

    static constexpr const char* name = "smith_correlated";
    static constexpr const char* label = "Smith, by height";
    static constexpr const char* explanation =
        "High facets are seen by both more often than low ones: P1 P2/(P1 + P2 \u2212 P1 P2) (Heitz 2014, "
        "eq. 99).";
    static constexpr const char* compared_label = "Same p, Smith by height";
    static constexpr const char* citation = "Heitz 2014, eq. 99";
    static constexpr const char* formula =
        "p1 = min(1, N z1/G1); p2 = min(1, N z2/G2); V = N/(G1 G2)/(p1 + p2 - p1 p2)";
    static constexpr const char* part = "height correlation";
    static constexpr MaskingBends bends = MaskingBends::horizon;
    static constexpr FacetWalk walk = FacetWalk::smith;
    static constexpr auto parameters() { return std::tuple{}; }

    double shader_width() const { return 1; }  // read by no one
    ExtremeClaims tilted_claims(bool clamp) const { return strongly_correlated_claims(clamp); }
};

}  // namespace nacre
