// The energy of the paper's slanted velvet (Ashikhmin 2000, sec. 6.4).
#pragma once

#include <stop_token>

#include "core/design/design.h"
#include "core/verify/albedo_check.h"

namespace nacre {

// Of perfect mirrors, and nothing diffuse; the paper's has N times 2 and no clamp.
Design slanted_white(double mean_cosine_scale, bool clamp);

// R on 200 directions.
AlbedoCheck slanted_energy(double mean_cosine_scale, bool clamp, const std::stop_token& stop);

}  // namespace nacre
