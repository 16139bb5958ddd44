// The pixels of a normal map one by one.
#pragma once

#include <cstddef>

#include "core/image/picture.h"
#include "core/model/lobe.h"
#include "core/model/picture_source.h"

namespace nacre {

// The numbers of one pixel of a normal map as they are read, of whatever length.
dvec3 pixel_normal(const ColourPicture& picture, const NormalReading& reading, std::size_t pixel);

// visit(i) of every `step`-th pixel of every step-th row.
template <class Visit>
void visit_pixels(const ColourPicture& picture, int step, const Visit& visit) {
    for (int row = 0; row < picture.height; row += step)
        for (int column = 0; column < picture.width; column += step)
            visit(static_cast<std::size_t>(row) * static_cast<std::size_t>(picture.width) +
                  static_cast<std::size_t>(column));
}

}  // namespace nacre
