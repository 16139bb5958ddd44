// How facets hide one another from light and eye, with P(k) = N (k.n)/g(k) (Ashikhmin et al. 2000, eq. 25).
// To add a model: core/model/masking/NAME.h, shaders/masking/NAME.glsl and a line in core/model/kinds.cmake.
#pragma once

#include <concepts>
#include <variant>

#include "core/model/kinds/extreme_claims.h"
#include "core/model/kinds/kind.h"
#include "core/model/masking_list.h"

namespace nacre {

// Besides what every kind has:
//
//   bends           where integration must cut
//   walk            how light goes on between facets
//   shader_width()  the width that NAME_masking() of shaders/masking/NAME.glsl reads, degrees
//   formula         V = P12/(N c1 c2), as the manifest of exported tables has it
//   part            what the shader leaves out with every other model; null for nothing
//   compared_label  what it is called beside the design that it is compared with
//   citation        where it comes from
//
// It may have tilted_claims(clamp): what is expected of a tilted p, where it is more than usual.
template <class T>
concept MaskingModelKind = Kind<T> && requires(const T model) {
    { T::bends } -> std::convertible_to<MaskingBends>;
    { T::walk } -> std::convertible_to<FacetWalk>;
    { model.shader_width() } -> std::same_as<double>;
    { T::formula } -> std::convertible_to<const char*>;
    { T::part } -> std::convertible_to<const char*>;
    { T::compared_label } -> std::convertible_to<const char*>;
    { T::citation } -> std::convertible_to<const char*>;
};

template <MaskingModelKind... T>
using MaskingModels = std::variant<T...>;

using MaskingModel = MaskingModels<NACRE_MASKING>;

// What the shader leaves out where the model of that index is not used; null for nothing.
constexpr const char* masking_part(std::size_t index) {
    return KindSet<MaskingModel>::each([]<class T>() { return static_cast<const char*>(T::part); }).at(index);
}

// Where the model of that index bends.
constexpr MaskingBends masking_bends(std::size_t index) {
    return KindSet<MaskingModel>::each([]<class T>() { return T::bends; }).at(index);
}

// How light goes on between the facets under the model of that index.
constexpr FacetWalk facet_walk(std::size_t index) {
    return KindSet<MaskingModel>::each([]<class T>() { return T::walk; }).at(index);
}

inline ExtremeClaims tilted_claims(const MaskingModel& model, bool clamp) {
    return std::visit(
        [&](const auto& kind) -> ExtremeClaims {
            if constexpr (requires { kind.tilted_claims(clamp); })
                return kind.tilted_claims(clamp);
            else
                return weakly_correlated_claims(clamp);
        },
        model);
}

}  // namespace nacre
