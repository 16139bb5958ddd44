// The names of the design file, each list in the order of its variant's or enum's alternatives.
#pragma once

#include <array>
#include <string_view>
#include <variant>

#include "core/design/design.h"

namespace nacre {

inline constexpr std::array<std::string_view, 7> lobe_names = {
    "gaussian", "inverse_gaussian", "ggx", "beckmann", "uniform", "curve", "painted"};
inline constexpr std::array<std::string_view, 2> domain_names = {"hemisphere", "sphere"};
inline constexpr std::array<std::string_view, 3> shadowing_names = {"uncorrelated", "correlated",
                                                                    "smith_correlated"};
inline constexpr std::array<std::string_view, 4> fresnel_names = {"schlick", "dielectric", "conductor",
                                                                  "none"};
inline constexpr std::array<std::string_view, 4> diffuse_names = {"none", "lambertian", "coupled", "metal"};

static_assert(lobe_names.size() == std::variant_size_v<Lobe>);
static_assert(fresnel_names.size() == std::variant_size_v<Fresnel>);
static_assert(diffuse_names.size() == std::variant_size_v<Diffuse>);

}  // namespace nacre
