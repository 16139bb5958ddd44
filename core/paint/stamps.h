// Pictures to stamp with that need no file.
#pragma once

#include <glm/vec2.hpp>
#include <memory>
#include <string>
#include <vector>

#include "core/image/raster.h"

namespace nacre {

struct NamedStamp {
    std::string name;
    std::shared_ptr<const Raster> picture;  // square, white paints
    glm::dvec2 reach{1};                    // of what paints, from the middle; the picture reaches to 1
};

// With the reach that the picture has; 1 where nothing of it paints.
NamedStamp named_stamp(std::string name, std::shared_ptr<const Raster> picture);

std::vector<NamedStamp> built_in_stamps();

}  // namespace nacre
