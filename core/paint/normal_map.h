// p(h) of a surface from a picture of its normals or of its heights.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/image/picture.h"
#include "core/image/raster.h"
#include "core/model/lobe.h"
#include "core/model/picture_source.h"

namespace nacre {

struct NormalMapLook {
    NormalReading reading;  // what the numbers speak for; green up
    // The slopes of a surface have no curl: which way of green is nearer to that, where one plainly is.
    std::optional<bool> green_down;
};

// Signed or not: under which of both the normals' lengths lie nearer to 1 in the mean. Two channels: the file
// has no more, or its blue is the same everywhere and no z of the others.
NormalMapLook look_at_normal_map(const ColourPicture& picture);

// Unit normals that face up, of every `step`-th pixel of every step-th row. A UserError of no file where the
// picture has one grey channel alone.
std::vector<dvec3> normals_of_map(const ColourPicture& picture, const NormalReading& reading, int step = 1);

struct NormalCounts {
    std::size_t pixels = 0;
    std::size_t empty = 0;          // left out: black, transparent or without a direction
    std::size_t not_facing_up = 0;  // left out: on the horizon or below it
    std::size_t resized = 0;        // taken, with a length that was off 1 by more than a twentieth
};

// Of the same pixels.
NormalCounts count_normals(const ColourPicture& picture, const NormalReading& reading, int step = 1);

// In one line what is left out or changed; empty where every pixel is a normal of length 1.
std::string note_on(const NormalCounts& counts);

// Of a height map that is periodic and whose heights, the mean of the colours, are `depth` picture widths
// from black to white, from white to black where that is negative: central differences, at every `step`-th
// pixel of every step-th row. Heights may have any sign.
std::vector<dvec3> normals_of_heights(const ColourPicture& picture, double depth, int step = 1);

// The share of the facets' area on each normal, as a painted layer's raster with a largest value of 1. Each
// normal counts the same area as seen from above, so for 1/n.z of facets; no more than for 50. `width`
// smooths it, the standard deviation in degrees near n. A UserError of no file where no normal faces up.
std::shared_ptr<const Raster> raster_of_normals(const std::vector<dvec3>& normals, double width);

}  // namespace nacre
