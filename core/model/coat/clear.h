#pragma once

#include <glm/exponential.hpp>
#include <tuple>

#include "core/base/limits.h"
#include "core/model/coat/shader_coat.h"
#include "core/model/kinds/parameter.h"
#include "core/model/lobes/beckmann.h"

namespace nacre {

// A layer of lacquer: its own highlight, Beckmann's (Beckmann and Spizzichino 1963), and what it absorbs
// (Beer and Lambert).
struct ClearCoat {
    double roughness = 0.05;
    double ior = 1.5;
    glm::dvec3 colour{1};
    bool operator==(const ClearCoat&) const = default;

    static constexpr const char* name = "clear";
    static constexpr const char* label = "Clear coat";
    static constexpr const char* explanation =
        "A layer of lacquer over the facets, with a highlight of its own: car paint, varnish, a wet "
        "surface.\n"
        "\u03c1 = \u03c1 of the coat + t(k1) t(k2)/n\u00b2 (\u03c1 beneath + what goes back and forth)";
    static constexpr int file_version = 2;
    static constexpr auto parameters() {
        return std::tuple{
            NumberParameter<ClearCoat>{
                .member = &ClearCoat::roughness,
                .text = {"roughness", "Roughness##Coat roughness",
                         "Width of the coat's own highlight, Beckmann's alpha: 0.02 fresh lacquer, 0.2 "
                         "satin varnish, 0.4 dull.",
                         "coat_roughness"},
                .bounds = {limits::coat_roughness_min, 1},
                .slider = {.ends = {limits::coat_roughness_min, 0.5}}},
            NumberParameter<ClearCoat>{
                .member = &ClearCoat::ior,
                .text = {"ior", "IOR##Coat IOR",
                         "Index of refraction n of the coat: water 1.33, lacquer 1.5. What lies beneath "
                         "reflects less than in air, as wet things are darker.",
                         "coat_ior"},
                .bounds = {limits::coat_ior_min, limits::coat_ior_max},
                .slider = {.ends = {1, 2}}},
            ColourParameter<ClearCoat>{
                .member = &ClearCoat::colour,
                .text = {"colour", "Colour##Coat colour",
                         "What is left of white light that goes straight down through the coat and back "
                         "up: colour\u00b2 on a way twice as long. White absorbs nothing.",
                         "coat_colour"},
                .bounds = {limits::coat_colour_min, 1}}};
    }

    static constexpr const char* formula =
        "D = exp((1 - 1/hz^2)/coat_roughness^2)/(pi coat_roughness^2 hz^4)";
    static constexpr const char* area_formula =
        "s = sqrt(max(0, 1 - z^2)); a = coat_roughness s; q = a/(a + 0.3275911 z); j = exp(-min(80, "
        "(z/max(a, 1e-9))^2)); "
        "l = q (0.254829592 + q (-0.284496736 + q (1.421413741 + q (-1.453152027 + q 1.061405429)))); "
        "gc = max(z, z (1 - 0.5 l j) + 0.28209479177387814 a j)";
    static constexpr bool covers = true;
    BeckmannLobe lobe() const { return {roughness, roughness}; }
    ShaderCoat shader() const { return {roughness, ior, -0.5 * glm::log(colour)}; }
};

}  // namespace nacre
