// What p is made of: lobes with their weights and frames. Angles in degrees.
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/model/lobes.h"
#include "core/model/modulation.h"
#include "core/model/picture_source.h"

namespace nacre {

struct Layer {
    std::string name;
    bool enabled = true;
    Lobe lobe = GaussianLobe{};
    double weight = 1;    // share of facet area, relative to the other layers'
    double rotation = 0;  // about the lobe's own axis, first
    double tilt = 0;      // then the axis is tilted from n ...
    double azimuth = 0;   // ... toward this azimuth
    std::optional<Modulation> modulation;
    glm::dvec3 tint{1};  // reflectance of its facets besides F, each colour 0 to 1
    // Of a painted lobe, where its raster was made from a picture and is still as it was made.
    std::optional<PictureSource> source = {};

    bool operator==(const Layer&) const = default;
};

// Whether it has any facets of p.
inline bool counts(const Layer& layer) { return layer.enabled && layer.weight > 0; }

inline bool holds_picture(const Layer& layer) {
    return layer.modulation.has_value() || holds_picture(layer.lobe);
}

struct Distribution {
    std::vector<Layer> layers = {Layer{}};
    double mean_cosine_scale = 1;  // multiplies N = <n.h>; the paper doubles it for slanted velvet
    bool operator==(const Distribution&) const = default;
};

}  // namespace nacre
