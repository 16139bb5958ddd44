// The document: everything an artist edits, as one plain value. Panels edit it, the bake reads it,
// undo keeps it and the file holds it. Angles in degrees, colours linear Rec. 709.
#pragma once

#include <string>

#include "core/model/coat_models.h"
#include "core/model/diffuse_models.h"
#include "core/model/fresnel_models.h"
#include "core/model/layer.h"
#include "core/model/masking_models.h"
#include "core/model/multibounce_models.h"
#include "core/model/retro.h"

namespace nacre {

struct Shadowing {
    MaskingModel model = UncorrelatedMasking{};
    bool clamp = true;  // P~ = min(1, N c / g); false is the paper's own form
    bool operator==(const Shadowing&) const = default;
};

struct Specular {
    double intensity = 1;  // a factor, applied last: g, R and the coupled diffuse term are those of 1
    bool operator==(const Specular&) const = default;
};

struct Design {
    std::string name;
    std::string note;
    Distribution distribution;
    Shadowing shadowing;
    Fresnel fresnel = SchlickFresnel{};
    Diffuse diffuse = NoDiffuse{};
    Multibounce multibounce = NoMultibounce{};
    Specular specular;
    Retro retro;
    Coat coat = NoCoat{};

    bool operator==(const Design&) const = default;
};

}  // namespace nacre
