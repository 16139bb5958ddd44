// A layer over the facets. To add a model: core/model/coat/NAME.h, shaders/coat/NAME.glsl and a line in
// core/model/kinds.cmake.
#pragma once

#include <concepts>
#include <variant>

#include "core/model/coat_list.h"
#include "core/model/kinds/kind.h"

namespace nacre {

// Besides what every kind has:
//
//   covers    whether there is such a layer at all
//   lobe()    of one that covers: the lobe whose facets are as dense as those at its outside
//   shader()  the numbers that shaders/shared/coat.glsl reads
//   formula, area_formula
//             density D of the facets at its outside, hz being the z of h, and their projected area gc, as
//             the manifest of exported tables has them
template <class T>
concept CoatFacets = !T::covers || requires(const T model) {
    model.lobe();
};

template <class T>
concept CoatModel = Kind<T> && CoatFacets<T> && requires(const T model) {
    { T::covers } -> std::convertible_to<bool>;
    { model.shader() } -> std::same_as<ShaderCoat>;
    { T::formula } -> std::convertible_to<const char*>;
    { T::area_formula } -> std::convertible_to<const char*>;
};

template <CoatModel... T>
using CoatModels = std::variant<T...>;

using Coat = CoatModels<NACRE_COAT>;

constexpr bool is_coated(std::size_t index) {
    return KindSet<Coat>::each([]<class T>() { return T::covers; }).at(index);
}

inline bool is_coated(const Coat& model) { return is_coated(model.index()); }

// The index of refraction that the facets lie in; 1 for air.
inline double index_above(const Coat& model) {
    return std::visit([](const auto& kind) { return kind.shader().ior; }, model);
}

}  // namespace nacre
