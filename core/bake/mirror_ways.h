// The ways in which samples of the specular term go; see shaders/shared/retro.glsl.
#pragma once

#include <array>

#include "core/model/lobe_model.h"
#include "core/model/shading.h"

namespace nacre {

// A facet mirrors k1, with half a turn about n before or after it.
struct MirrorWay {
    double part = 1;  // of the samples
    bool before = false, after = false;

    dvec3 entering(dvec3 k1) const { return before ? Shading<double>::turned(k1) : k1; }
    dvec3 leaving(dvec3 k2) const { return after ? Shading<double>::turned(k2) : k2; }
};

// Their parts add up to 1; but the first all are 0 without retro-reflection.
inline std::array<MirrorWay, 3> mirror_ways(const Shading<double>& shading) {
    const double retro = shading.kinds.retro ? shading.surface.retro : 0;
    return {{{1 - retro, false, false}, {0.5 * retro, true, false}, {0.5 * retro, false, true}}};
}

// One of them, each as often as its part says. Without retro-reflection no random number is drawn.
inline MirrorWay draw_way(const Shading<double>& shading, Random& random) {
    const auto ways = mirror_ways(shading);
    if (!shading.kinds.retro) return ways[0];
    const double at = uniform_random(random);
    return at < ways[1].part ? ways[1] : at < ways[1].part + ways[2].part ? ways[2] : ways[0];
}

}  // namespace nacre
