// F(k.h), how much a facet reflects. To add a model: core/model/fresnel/NAME.h, shaders/fresnel/NAME.glsl and
// a line in core/model/kinds.cmake.
#pragma once

#include <concepts>
#include <variant>

#include "core/model/fresnel_list.h"
#include "core/model/kinds/kind.h"

namespace nacre {

// Besides what every kind has:
//
//   tables                   which tables of R it needs
//   shader()         the numbers that NAME_fresnel() of shaders/fresnel/NAME.glsl reads, or the table
//   beneath(above)   itself in a medium of that index; a model that is a table has shader(above) in its place
//   of_reflectance() the model with this F, as nearly as it can have it: straight on first
//   formula          F at c = k.h, as the manifest of exported tables has it
//   note             what the window says of it where it has no parameter
//
// It may have
//
//   is_metal         true: nothing is below its facets, so that what they do not mirror out at once bounces
//   on is_curve         true: F is a table, which shader() gives and NAME_fresnel() reads by table_fresnel()
template <class T>
concept FresnelBeneath = requires(const T model) {
    { model.beneath(1.5) } -> std::same_as<T>;
}
|| requires(const T model) {
    { model.shader(1.5) } -> std::same_as<ShaderFresnel>;
};

template <class T>
concept FresnelModel = Kind<T> && FresnelBeneath<T> && requires(const T model, const Reflectance& wanted) {
    { T::tables } -> std::convertible_to<FresnelTables>;
    { model.shader() } -> std::same_as<ShaderFresnel>;
    { T::of_reflectance(wanted) } -> std::same_as<T>;
    { T::formula } -> std::convertible_to<const char*>;
    { T::note } -> std::convertible_to<const char*>;
};

template <FresnelModel... T>
using FresnelModels = std::variant<T...>;

using Fresnel = FresnelModels<NACRE_FRESNEL>;

inline constexpr auto tables_of_fresnel = KindSet<Fresnel>::each([]<class T>() { return T::tables; });

// Which tables of R the model of that index needs.
constexpr FresnelTables fresnel_tables(std::size_t index) { return tables_of_fresnel[index]; }

inline constexpr auto curves_of_fresnel = KindSet<Fresnel>::each([]<class T>() {
    if constexpr (requires { T::is_curve; })
        return T::is_curve;
    else
        return false;
});

inline constexpr auto metals_of_fresnel = KindSet<Fresnel>::each([]<class T>() {
    if constexpr (requires { T::is_metal; })
        return T::is_metal;
    else
        return false;
});

constexpr bool is_metal(const Fresnel& fresnel) { return metals_of_fresnel[fresnel.index()]; }

// Whether the model of that index is a table.
constexpr bool fresnel_is_curve(std::size_t index) { return curves_of_fresnel[index]; }

constexpr FresnelTables fresnel_tables(const Fresnel& fresnel) { return fresnel_tables(fresnel.index()); }

// The model in a medium of index `above`, 1 for air; of one that is a table itself.
inline Fresnel beneath(const Fresnel& fresnel, double above) {
    return std::visit(
        [&]<class T>(const T& model) -> Fresnel {
            if constexpr (requires { model.beneath(above); })
                return model.beneath(above);
            else
                return model;
        },
        fresnel);
}

// What its shader reads there.
inline ShaderFresnel shader_beneath(const Fresnel& fresnel, double above) {
    return std::visit(
        [&]<class T>(const T& model) {
            if constexpr (requires { model.beneath(above); })
                return model.beneath(above).shader();
            else
                return model.shader(above);
        },
        fresnel);
}

}  // namespace nacre
