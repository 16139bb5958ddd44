// The model of a layer's lobe.
#pragma once

#include "core/model/layer.h"
#include "core/model/lobe_model.h"

namespace nacre {

// The model of a layer's lobe, its modulation included; frame, weight and name play no part.
std::shared_ptr<const LobeModel> make_lobe(const Layer& layer, Fineness fineness = Fineness::bake);

}  // namespace nacre
