// The values that R has at one direction.
#pragma once

#include <glm/vec3.hpp>

#include "core/model/quadrature.h"
#include "core/model/tint.h"

namespace nacre {

// What facets of one layer add to R, their tint left out: with F = 1, then with one or three Fresnel factors
// (Schlick's weight, or the design's exact F).
using LayerAlbedo = Values<4>;

// R as the tables hold it: with F = 1, then with the Fresnel factors.
using AlbedoValues = Values<6>;

// Which of these there are. Where tints differ each colour has its own: three with F = 1, three with the
// Fresnel factor. Otherwise one with F = 1 serves every colour, and a tint that all layers share is left out.
struct AlbedoLayout {
    int channels = 0;  // Fresnel factors of a facet: 0, 1 (Schlick's weight) or 3 (exact, a colour each)
    Tint tint = Tint::none;

    int full() const { return tint == Tint::varied ? 3 : 1; }
    int factors() const { return tint == Tint::varied && channels > 0 ? 3 : channels; }
    int size() const { return full() + factors(); }

    // Adds a layer's part; `tinted` is its tint.
    void add(const LayerAlbedo& layer, glm::dvec3 tinted, AlbedoValues& sum) const {
        if (tint != Tint::varied) {
            for (std::size_t i = 0; i < layer.size(); ++i) sum[i] += layer[i];
            return;
        }
        for (int c = 0; c < 3; ++c) {
            const auto at = static_cast<std::size_t>(c);
            sum[at] += tinted[c] * layer[0];
            if (channels > 0) sum[3 + at] += tinted[c] * layer[channels == 1 ? 1 : 1 + at];
        }
    }
};

}  // namespace nacre
