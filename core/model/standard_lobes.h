// Lobes with closed forms: GGX, Beckmann and the uniform distributions.
#pragma once

#include "core/model/lobe.h"

namespace nacre {

std::shared_ptr<const LobeModel> make_ggx_lobe(const GgxLobe& lobe);
std::shared_ptr<const LobeModel> make_beckmann_lobe(const BeckmannLobe& lobe);
std::shared_ptr<const LobeModel> make_uniform_lobe(const UniformLobe& lobe);

}  // namespace nacre
