// A box of handles, on the equal-area disk.
#pragma once

#include "core/model/lobe_model.h"

namespace nacre {

// A box on the equal-area disk, its corners at (-1, -1) to (1, 1) of its own.
struct DiskBox {
    dvec2 middle{0};
    dvec2 right{1, 0}, up{0, 1};  // half its sides

    dvec2 at(dvec2 own) const { return middle + right * own.x + up * own.y; }
    dvec2 own(dvec2 at) const;

    bool operator==(const DiskBox&) const = default;
};

DiskBox turned(const DiskBox& box, double angle);  // about its middle, radians counterclockwise

// With a corner or the middle of a side, by its own coordinates, pulled to another place, while the one
// across stays. `in_ratio`: width and height keep their ratio. It never becomes too thin to be pulled open
// again.
DiskBox pulled(const DiskBox& box, dvec2 handle, dvec2 to, bool in_ratio);

}  // namespace nacre
