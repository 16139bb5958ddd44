// Designs that tests of the model share.
#pragma once

#include "core/design/design.h"

namespace nacre::test {

inline Design design_of(Lobe lobe, double tilt = 0, double azimuth = 0, double rotation = 0) {
    Design design;
    Layer& layer = design.distribution.layers.front();
    layer.lobe = std::move(lobe);
    layer.tilt = tilt;
    layer.azimuth = azimuth;
    layer.rotation = rotation;
    design.fresnel = SchlickFresnel{};
    return design;
}

inline Design with_layer(Design design, Lobe lobe, double weight, double tilt = 0, double azimuth = 0) {
    Layer layer;
    layer.lobe = std::move(lobe);
    layer.weight = weight;
    layer.tilt = tilt;
    layer.azimuth = azimuth;
    design.distribution.layers.push_back(layer);
    return design;
}

// A grey picture from a function of the disk's x and y in [-1, 1].
template <class Function>
Picture picture_of(int side, const Function& value) {
    auto raster = std::make_shared<Raster>();
    raster->width = raster->height = side;
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column)
            raster->values.push_back(
                static_cast<float>(value(2 * (column + 0.5) / side - 1, 1 - 2 * (row + 0.5) / side)));
    return {{}, raster};
}

// The paper's slanted velvet (sec. 6.4).
inline Design slanted_velvet(double mean_cosine_scale, bool clamp) {
    Design design = design_of(GaussianLobe{0.5, limits::infinity}, 40);
    design.distribution.mean_cosine_scale = mean_cosine_scale;
    design.shadowing.model = CorrelatedMasking{};
    design.shadowing.clamp = clamp;
    return design;
}

}  // namespace nacre::test
