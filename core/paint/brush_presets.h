// Brushes with names.
#pragma once

#include <string>
#include <vector>

#include "core/paint/brush.h"

namespace nacre {

struct NamedBrush {
    std::string name;
    Brush brush;

    bool operator==(const NamedBrush&) const = default;
};

std::vector<NamedBrush> built_in_brushes();

}  // namespace nacre
