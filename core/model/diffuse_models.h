// Light that leaves other than by one mirror reflection. To add a model: core/model/diffuse/NAME.h,
// shaders/diffuse/NAME.glsl and a line in core/model/kinds.cmake.
#pragma once

#include <concepts>
#include <variant>

#include "core/model/diffuse_list.h"
#include "core/model/kinds/kind.h"

namespace nacre {

// Besides what every kind has:
//
//   reads_albedo  whether it reads R, so that the tables must hold it
//   matt_facets   whether it reads tables of facets that are matt themselves (core/bake/facet_tables.h)
//   shader()      the numbers that shaders/diffuse/NAME.glsl reads; f0 is F(1) of the design
//                 times its mean tint
//   own_albedo()  the albedo it was given, if it has one of its own; of_albedo() carries one on
//   formula       the whole BRDF, as the manifest of exported tables has it
//   note          what the window says of it where it has no parameter
template <class T>
concept DiffuseModel = Kind<T> && requires(const T model, glm::dvec3 albedo) {
    { T::reads_albedo } -> std::convertible_to<bool>;
    { T::matt_facets } -> std::convertible_to<bool>;
    { model.shader(albedo) } -> std::same_as<ShaderDiffuse>;
    { T::formula } -> std::convertible_to<const char*>;
    { model.own_albedo() } -> std::same_as<std::optional<glm::dvec3>>;
    { T::of_albedo(albedo) } -> std::same_as<T>;
    { T::note } -> std::convertible_to<const char*>;
};

template <DiffuseModel... T>
using DiffuseModels = std::variant<T...>;

using Diffuse = DiffuseModels<NACRE_DIFFUSE>;

inline bool reads_albedo(const Diffuse& diffuse) {
    return std::visit([]<class T>(const T&) { return T::reads_albedo; }, diffuse);
}

constexpr bool has_matt_facets(std::size_t index) {
    return KindSet<Diffuse>::each([]<class T>() { return T::matt_facets; }).at(index);
}

inline bool has_matt_facets(const Diffuse& diffuse) { return has_matt_facets(diffuse.index()); }

}  // namespace nacre
