// The lobes that a layer of p can have. To add one: core/model/lobes/NAME.h, shaders/lobes/NAME.glsl and a
// line in core/model/kinds.cmake.
#pragma once

#include <concepts>
#include <string_view>
#include <type_traits>
#include <variant>

#include "core/model/kinds/kind.h"
#include "core/model/lobes_list.h"

namespace nacre {

// Besides what every kind has:
//
//   width_members   which of its members are widths, for handles and for conversion
//   of_widths()     the lobe of this kind that has these widths as nearly as it can
//   period()        degrees after which it looks the same, turned about its own axis; 0: it is round
//   reaches_below() whether it holds facets below its own horizon
//   shader()        the numbers that NAME_lobe() of shaders/lobes/NAME.glsl reads
//   model()         its mathematics; or modulated_model(), when its own picture and a modulation's become one
//   table_kind()    what the manifest of exported tables calls it
//   formula()       what it is there at h = (x, y, z) of its own frame, 0 where z <= 0 unless said otherwise;
//                   (i, j) is inverse_width
template <class T>
concept LobeKind = Kind<T> && requires(const T lobe, glm::dvec2 widths) {
    { T::width_members } -> std::convertible_to<WidthMembers<T>>;
    { T::of_widths(widths) } -> std::same_as<T>;
    { lobe.period() } -> std::same_as<double>;
    { lobe.reaches_below() } -> std::same_as<bool>;
    { lobe.shader() } -> std::same_as<ShaderLobe>;
    { lobe.table_kind() } -> std::convertible_to<const char*>;
    { lobe.formula() } -> std::convertible_to<const char*>;
};

template <LobeKind... T>
using Lobes = std::variant<T...>;

using Lobe = Lobes<NACRE_LOBES>;

// visit(picture, key) of each picture that a lobe holds.
template <class AnyLobe, class Visit>
void visit_pictures(AnyLobe& lobe, const Visit& visit) {
    std::visit(
        [&](auto& kind) {
            using T = std::remove_cvref_t<decltype(kind)>;
            visit_parameters<T>([&]<class Parameter>(const Parameter& parameter) {
                if constexpr (std::is_same_v<Parameter, PictureParameter<T>>)
                    visit(kind.*parameter.member, parameter.text.key);
            });
        },
        lobe);
}

// Whether the lobe of that index holds a picture, which the shader reads.
inline bool lobe_reads_picture(int index) {
    bool reads = false;
    const Lobe lobe = KindSet<Lobe>::made(static_cast<std::size_t>(index));
    visit_pictures(lobe, [&](const Picture&, std::string_view) { reads = true; });
    return reads;
}

inline bool holds_picture(const Lobe& lobe) { return lobe_reads_picture(static_cast<int>(lobe.index())); }

inline double period_of(const Lobe& lobe) {
    return std::visit([](const auto& kind) { return kind.period(); }, lobe);
}

inline bool reaches_below(const Lobe& lobe) {
    return std::visit([](const auto& kind) { return kind.reaches_below(); }, lobe);
}

// The lobe of that index that has these widths as nearly as it can.
inline Lobe lobe_of_widths(std::size_t index, glm::dvec2 widths = glm::dvec2(default_width)) {
    return KindSet<Lobe>::made_by(index, [&]<class T>() { return T::of_widths(widths); });
}

// Slopes at which the lobe has fallen to 1/e along x and y; of a lobe without widths, default_width.
inline glm::dvec2 widths_of(const Lobe& lobe) {
    return std::visit(
        []<class T>(const T& kind) {
            constexpr WidthMembers<T> widths = T::width_members;
            if constexpr (widths.x == nullptr)
                return glm::dvec2(default_width);
            else
                return glm::dvec2(kind.*widths.x, kind.*widths.y);
        },
        lobe);
}

}  // namespace nacre
