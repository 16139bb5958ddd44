// The envelope of a lobe that is multiplied by a picture.
#pragma once

#include <memory>

#include "core/model/lobe_envelope.h"
#include "core/model/picture_reader.h"

namespace nacre {

// The lobe's own envelope times the most that the factor is over each patch. `factor` is kept as a reference;
// null where `lobe` is.
std::unique_ptr<const LobeEnvelope> make_modulated_envelope(std::unique_ptr<const LobeEnvelope> lobe,
                                                            const ModulationFactor& factor);

}  // namespace nacre
