// Pictures to stamp with that need no file.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/design/design.h"

namespace nacre {

struct NamedStamp {
    std::string name;
    std::shared_ptr<const Raster> picture;  // square, white paints
};

std::vector<NamedStamp> built_in_stamps();

}  // namespace nacre
