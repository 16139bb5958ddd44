#include "core/pictures/made_square.h"

#include <fmt/core.h>

#include <algorithm>

#include "core/base/limits.h"
#include "core/image/area_average.h"
#include "core/image/letterbox.h"

namespace nacre {

Raster made_square(const Raster& raster, PictureNotes& notes) {
    const int side = std::max(raster.width, raster.height), kept = std::min(side, limits::raster_max);
    std::string changes = raster.width != raster.height ? ", made square with black beside it" : "";
    if (kept < side) changes += fmt::format(", averaged down to {} x {}", kept, kept);
    if (!changes.empty())
        notes.push_back(fmt::format("{} x {} pixels{}", raster.width, raster.height, changes));
    const Raster square = letterboxed(raster);
    return kept < side ? area_average(square, kept) : square;
}

}  // namespace nacre
