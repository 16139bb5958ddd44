// A set of kinds is a std::variant of their structs: that list alone says which there are. Each kind has
//
//   name         in files and on the command line
//   label        in the window
//   explanation  for its tooltip, with the equation
//   parameters() a tuple of what parameter.h declares, one for each member
//
// and what its own set asks for besides (lobes.h, fresnel_models.h, diffuse_models.h, masking_models.h). It
// may have
//
//   fault()    the rule between its parameters that is broken
//   singular() names and values that are extreme but lie within the bounds, for core/study/kind_extremes.h
//   file_version the first version of design files that has it, where that is not 1
//   extreme_claims() what is expected of a design with it, where that is more than usual (extreme_claims.h)
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <variant>

#include "core/model/kinds/parameter.h"

namespace nacre {

// A rule between a kind's parameters that is broken, for a message: where, what is allowed, what was found.
struct KindFault {
    std::string_view key;  // of the parameter; empty for the kind as a whole
    std::string problem;
    std::string found;
};

namespace kind_detail {

// Stands for any member in an aggregate's braces.
struct Anything {
    template <class T>
    operator T() const;
};

template <class T, class... Members>
consteval std::size_t member_count() {
    if constexpr (requires { T{Members{}..., Anything{}}; })
        return member_count<T, Members..., Anything>();
    else
        return sizeof...(Members);
}

}  // namespace kind_detail

template <class T>
concept Kind = std::equality_comparable<T> && requires {
    { T::name } -> std::convertible_to<std::string_view>;
    { T::label } -> std::convertible_to<const char*>;
    { T::explanation } -> std::convertible_to<const char*>;
    T::parameters();
};

// visit(parameter) for each parameter of a kind, in order.
template <Kind T, class Visit>
void visit_parameters(const Visit& visit) {
    static_assert(std::tuple_size_v<decltype(T::parameters())> == kind_detail::member_count<T>(),
                  "every member of a kind stands in its parameters()");
    std::apply([&](const auto&... parameter) { (visit(parameter), ...); }, T::parameters());
}

template <class Variant>
struct KindSet;

template <Kind... T>
struct KindSet<std::variant<T...>> {
    static constexpr std::size_t count = sizeof...(T);
    static constexpr std::array<std::string_view, count> names = {T::name...};
    static constexpr std::array<const char*, count> labels = {T::label...};
    static constexpr std::array<const char*, count> explanations = {T::explanation...};

    // What of.template operator()<T>() says of each kind.
    template <class Of>
    static constexpr auto each(const Of& of) {
        return std::array{of.template operator()<T>()...};
    }

    // The kind of that index, by make.template operator()<T>().
    template <class Make>
    static std::variant<T...> made_by(std::size_t index, const Make& make) {
        using Made = std::variant<T...> (*)(const Make&);
        static constexpr std::array<Made, count> makers = {
            [](const Make& m) -> std::variant<T...> { return m.template operator()<T>(); }...};
        return makers.at(index)(make);
    }

    // The same with default parameters.
    static std::variant<T...> made(std::size_t index) {
        return made_by(index, []<class Made>() { return Made{}; });
    }
};

// The place of a kind in its set.
template <class Variant, Kind T>
constexpr int kind_index() {
    constexpr auto find = []<class... All>(std::type_identity<std::variant<All...>>) {
        int index = 0, found = -1;
        ((found = std::is_same_v<All, T> ? index : found, ++index), ...);
        return found;
    };
    constexpr int index = find(std::type_identity<Variant>{});
    static_assert(index >= 0, "a kind of another set");
    return index;
}

// The name in files of what a variant holds.
template <class Variant>
std::string_view kind_name(const Variant& value) {
    return KindSet<Variant>::names[value.index()];
}

template <class Variant>
const char* kind_label(const Variant& value) {
    return KindSet<Variant>::labels[value.index()];
}

// The first version of design files that has what a variant holds.
template <class Variant>
int file_version(const Variant& value) {
    return std::visit(
        []<class T>(const T&) {
            if constexpr (requires { T::file_version; })
                return T::file_version;
            else
                return 1;
        },
        value);
}

// The rule that the held kind's parameters break, if it has any.
template <class Variant>
std::optional<KindFault> kind_fault(const Variant& value) {
    return std::visit(
        [](const auto& kind) -> std::optional<KindFault> {
            if constexpr (requires { kind.fault(); })
                return kind.fault();
            else
                return {};
        },
        value);
}

}  // namespace nacre
