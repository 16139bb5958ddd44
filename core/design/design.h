// The document: everything an artist edits, as one plain value. Panels edit it, the bake reads it,
// undo keeps it and the file holds it. Angles in degrees, colours linear Rec. 709.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/model/diffuse_models.h"
#include "core/model/fresnel_models.h"
#include "core/model/limits.h"
#include "core/model/lobes.h"
#include "core/model/masking_models.h"
#include "core/model/modulation.h"

namespace nacre {

struct Layer {
    std::string name;
    bool enabled = true;
    Lobe lobe = GaussianLobe{};
    double weight = 1;    // share of facet area, relative to the other layers'
    double rotation = 0;  // about the lobe's own axis, first
    double tilt = 0;      // then the axis leans from n ...
    double azimuth = 0;   // ... toward this azimuth
    std::optional<Modulation> modulation;

    bool operator==(const Layer&) const = default;
};

inline bool holds_picture(const Layer& layer) {
    return layer.modulation.has_value() || holds_picture(layer.lobe);
}

struct Distribution {
    std::vector<Layer> layers = {Layer{}};
    double mean_cosine_scale = 1;  // multiplies N = <n.h>; the paper doubles it for slanted velvet
    bool operator==(const Distribution&) const = default;
};

struct Shadowing {
    MaskingModel model = UncorrelatedMasking{};
    bool clamp = true;  // P~ = min(1, N c / g); false is the paper's own form
    bool operator==(const Shadowing&) const = default;
};

struct Design {
    std::string name;
    std::string note;
    Distribution distribution;
    Shadowing shadowing;
    Fresnel fresnel = SchlickFresnel{};
    Diffuse diffuse = NoDiffuse{};

    bool operator==(const Design&) const = default;
};

}  // namespace nacre
