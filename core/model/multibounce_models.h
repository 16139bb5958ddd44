// Light that leaves after two or more bounces between facets. To add a model: core/model/multibounce/NAME.h,
// shaders/multibounce/NAME.glsl and a line in core/model/kinds.cmake.
#pragma once

#include <concepts>
#include <variant>

#include "core/model/kinds/kind.h"
#include "core/model/multibounce_list.h"

namespace nacre {

// Besides what every kind has:
//
//   bounces  whether there is such light at all
//   fitted   whether its tables are fitted to random walks (core/bake/momentum_fit.h)
//   rest_formula, formula
//            e of one direction and M of two, of shaders/shared/multibounce.glsl, as the manifest of exported
//            tables has them
template <class T>
concept MultibounceModel = Kind<T> && requires {
    { T::bounces } -> std::convertible_to<bool>;
    { T::fitted } -> std::convertible_to<bool>;
    { T::rest_formula } -> std::convertible_to<const char*>;
    { T::formula } -> std::convertible_to<const char*>;
};

template <MultibounceModel... T>
using MultibounceModels = std::variant<T...>;

using Multibounce = MultibounceModels<NACRE_MULTIBOUNCE>;

constexpr bool has_bounces(std::size_t index) {
    return KindSet<Multibounce>::each([]<class T>() { return T::bounces; }).at(index);
}

inline bool has_bounces(const Multibounce& model) { return has_bounces(model.index()); }

inline bool is_fitted(const Multibounce& model) {
    return std::visit([]<class T>(const T&) { return T::fitted; }, model);
}

}  // namespace nacre
