// The paper's Gaussian (Ashikhmin 2000, eq. 34), exactly, for every width from needle to cylinder.
#pragma once

#include "core/model/lobe.h"

namespace nacre {

std::shared_ptr<const LobeModel> make_gaussian_lobe(const GaussianLobe& lobe);

}  // namespace nacre
