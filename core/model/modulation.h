#pragma once

#include "core/image/raster.h"

namespace nacre {

// Multiplies a lobe by 1 - strength + strength * picture, the picture lying in the lobe's own frame
// and being black outside its disk.
struct Modulation {
    Picture image;
    double strength = 1;
    bool operator==(const Modulation&) const = default;
};

}  // namespace nacre
