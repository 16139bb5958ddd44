#pragma once

#include <variant>

namespace nacre {

// What the sweep of extreme designs (core/study/extremes.h) expects of a design.
struct ExtremeClaims {
    // The most that the bake may claim as its error of g: its tolerance, and more where the largest tables
    // cannot keep it.
    double area = 1.5e-3;
    // The same of R.
    double albedo = 1e-2;
    // Part of what the bake refuses it with; empty: it must bake and be finite and non-negative.
    const char* refusal = "";
};

// Of a design with this kind of its set, upright: what the kind says, or the usual.
template <class Variant>
ExtremeClaims extreme_claims(const Variant& value) {
    return std::visit(
        [](const auto& kind) -> ExtremeClaims {
            if constexpr (requires { kind.extreme_claims(); })
                return kind.extreme_claims();
            else
                return {};
        },
        value);
}

// Of g, where p is tilted.
inline constexpr double tilted_area_claim = 4e-3;

// Of R, where it turns within the last cell before the horizon or within a thousandth of a degree of azimuth.
inline constexpr double layer_albedo_claim = 0.05;

// What the bake may claim with a masking model where p is tilted, on the side where it turns away: under
// clamp R falls to 0 closer to the horizon than a cell, from as much as it is there; without, it has no
// bound.
inline ExtremeClaims weakly_correlated_claims(bool clamp) { return {tilted_area_claim, clamp ? 0.15 : 0.9}; }
inline ExtremeClaims strongly_correlated_claims(bool clamp) { return {tilted_area_claim, clamp ? 1 : 1.5}; }

}  // namespace nacre
