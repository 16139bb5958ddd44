#pragma once

#include <tuple>

#include "core/model/kinds/kind.h"

namespace nacre {

// Retro-reflection: a part of the specular term that goes back to where the light came from. See
// shaders/shared/retro.glsl.
struct Retro {
    double weight = 0;
    bool operator==(const Retro&) const = default;

    static constexpr const char* name = "retro";
    static constexpr const char* label = "Retro-reflection";
    static constexpr const char* explanation =
        "A part of the highlight goes back to where the light came from: "
        "[\u03c1(k1, T k2) + \u03c1(T k1, k2)]/2, T half a turn about n.";
    static constexpr int file_version = 2;
    static constexpr auto parameters() {
        return std::tuple{NumberParameter<Retro>{
            .member = &Retro::weight,
            .text =
                {"weight", "Retro-reflection",
                 "How much of the highlight goes back to where the light came from, as from traffic signs, "
                 "cats' eyes or dusty velvet, in the shape that the facets give it: "
                 "[\u03c1(k1, T k2) + \u03c1(T k1, k2)]/2, T half a turn about n. "
                 "The rest is mirrored; no light is gained or lost."},
            .bounds = {0, 1},
            .slider = {.ends = {0, 1}, .format = "%.2f"}}};
    }
};

}  // namespace nacre
