#pragma once

#include <tuple>

#include "core/base/limits.h"
#include "core/model/kinds/extreme_claims.h"
#include "core/model/kinds/parameter.h"
#include "core/model/masking/facet_walk.h"
#include "core/model/masking/masking_bends.h"

namespace nacre {

// Ashikhmin et al. 2000, eq. 14.
struct CorrelatedMasking {
    double width = 15;  // standard deviation of t(phi), degrees
    bool operator==(const CorrelatedMasking&) const = default;

    static constexpr const char* name = "correlated";
    static constexpr const char* label = "Correlated by azimuth";
    static constexpr const char* explanation =
        "When light and eye are on the same side, what one sees the other sees too: (1 \u2212 t) P1 P2 + t "
        "min(P1, P2) "
        "(eq. 14).";
    static constexpr const char* compared_label = "Same p, by azimuth";
    static constexpr const char* citation = "Ashikhmin, Premoze and Shirley 2000, eq. 14";
    static constexpr const char* formula =
        "d = atan2(abs(x1 y2 - y1 x2), x1 x2 + y1 y2); t = exp(-(180 d/(pi correlation_width_degrees))^2/2); "
        "V = (1 - t) N/(G1 G2) + t/max(G1 z2, G2 z1): where k = (0, 0, 1), `axis` in the place of (x, y)";
    static constexpr const char* part = "azimuth correlation t(phi)";
    static constexpr MaskingBends bends = MaskingBends::azimuth;
    static constexpr FacetWalk walk = FacetWalk::uncorrelated;
    static constexpr auto parameters() {
        return std::tuple{NumberParameter<CorrelatedMasking>{
            .member = &CorrelatedMasking::width,
            .text =
                {"width", "Correlation",
                 "How far apart in azimuth light and eye may be and still share what they see: t = "
                 "exp(\u2212\u03c6\u00b2/(2 width\u00b2)). Wider brightens what is lit from behind the eye.",
                 "correlation_width_degrees"},
            .bounds = {limits::correlation_min, limits::correlation_max},
            .slider = {.ends = {1, 90}, .format = "%.1f\u00b0"}}};
    }

    double shader_width() const { return width; }
    ExtremeClaims tilted_claims(bool clamp) const {
        return width > 90 ? strongly_correlated_claims(clamp) : weakly_correlated_claims(clamp);
    }
};

}  // namespace nacre
