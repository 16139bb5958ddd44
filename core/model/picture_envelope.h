// The envelope of a painted lobe: the tents of its texels.
#pragma once

#include <memory>

#include "core/image/raster.h"
#include "core/model/lobe_envelope.h"

namespace nacre {

// `picture`: extended past the rim, see extended_past_rim(); as many texels a side as there are tents.
std::unique_ptr<const LobeEnvelope> make_picture_envelope(const Raster& picture);

}  // namespace nacre
