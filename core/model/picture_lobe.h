// Lobes that hold a picture: painted ones, and any other lobe multiplied by one.
#pragma once

#include "core/model/lobe.h"

namespace nacre {

// A product that is 0 everywhere has mass 0.
std::shared_ptr<const LobeModel> make_painted_lobe(const PaintedLobe& lobe,
                                                   const std::optional<Modulation>& modulation);

// `base` has spans(), so it is any lobe but a painted one.
std::shared_ptr<const LobeModel> make_modulated_lobe(std::shared_ptr<const LobeModel> base,
                                                     const Modulation& modulation);

}  // namespace nacre
