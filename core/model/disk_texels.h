// Which texels of a picture lie on the equal-area disk, and what the picture is near the disk's rim.
//
// A texel is on the disk where its middle is inside the horizon. The others count for nothing: before a
// picture is read they are given values from those on the disk, so that between middles it can be bilinear
// up to the rim.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/image/raster.h"
#include "core/model/disk.h"

namespace nacre {

// The middle of a texel on the equal-area disk. Mirrored texels have exactly mirrored middles where the side
// is a power of two.
inline glm::dvec2 texel_point(int side, int row, int column) {
    return {2 * (column + 0.5) / side - 1, 1 - 2 * (row + 0.5) / side};
}

// Solid angle of a texel, steradians.
inline double texel_solid_angle(int side) { return 2 * (2.0 / side) * (2.0 / side); }

// Exact: no texel's middle lies on the rim.
inline bool on_disk(int side, int row, int column) {
    const long x = 2L * column + 1 - side, y = 2L * row + 1 - side;
    return x * x + y * y < static_cast<long>(side) * side;
}

// The texels, by index, whose mean one off the disk takes: its neighbours one step toward the middle along
// the row and along the column, or where neither is on the disk the one a step along both. None for a texel
// so far out that nothing on the disk is interpolated from it.
struct TexelSources {
    int count = 0;
    std::array<std::size_t, 2> index{};
};
TexelSources texel_sources(int side, int row, int column);

// The picture as it is read: the same on the disk, off it as above, and 0 farther out.
Raster extended_past_rim(const Raster& picture);

// The integral over the hemisphere of the picture so read, steradians times its unit.
double raster_mass(const Raster& picture);

// The largest value on the disk.
float largest_on_disk(const Raster& picture);

// A picture's texels as they are read, over a power of two that brings the brightest into [1, 2): the digits
// stay, and neither the texels nor a layer's scale leave a float's range whatever unit the picture is in.
struct ScaledPicture {
    std::vector<float> texels;
    double unit;  // picture = unit * texels
};
ScaledPicture scaled_picture(const Raster& picture);

}  // namespace nacre
