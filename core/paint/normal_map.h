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

namespace nacre {

// How the numbers of a tangent-space normal map mean x (red), y (green) and z (blue). One decision for the
// whole map.
struct NormalReading {
    bool is_signed = false;     // the numbers as they are; else 0.5 is zero: 2 c - 1
    bool two_channels = false;  // blue is not read: z = sqrt(1 - x^2 - y^2)
    bool green_down = false;    // y points to the picture's lower edge, as DirectX has it; else up, as OpenGL

    bool operator==(const NormalReading&) const = default;
};

struct NormalMapLook {
    NormalReading reading;  // what the numbers speak for; green up
    // The slopes of a surface have no curl: which way of green is nearer to that, where one plainly is.
    std::optional<bool> green_down;
};

// Signed or not: under which of both the normals' lengths lie nearer to 1 in the mean. Two channels: the file
// has no more, or its blue is the same everywhere and no z of the others.
NormalMapLook look_at_normal_map(const ColourPicture& picture);

// Unit normals that face up. A UserError of no file where the picture has one grey channel alone.
std::vector<dvec3> normals_of_map(const ColourPicture& picture, const NormalReading& reading);

struct NormalCounts {
    std::size_t pixels = 0;
    std::size_t empty = 0;          // left out: black, transparent or without a direction
    std::size_t not_facing_up = 0;  // left out: on the horizon or below it
    std::size_t resized = 0;        // taken, with a length that was off 1 by more than a twentieth
};

NormalCounts count_normals(const ColourPicture& picture, const NormalReading& reading);

// In one line what is left out or changed; empty where every pixel is a normal of length 1.
std::string note_on(const NormalCounts& counts);

// Of a height map that is periodic and whose heights, the mean of the colours, are `depth` picture widths
// from black to white, from white to black where that is negative: central differences. Heights may have any
// sign.
std::vector<dvec3> normals_of_heights(const ColourPicture& picture, double depth);

// The share of the facets' area on each normal, as a painted layer's raster with a largest value of 1. Each
// normal counts the same area as seen from above, so for 1/n.z of facets; no more than for 50. `width`
// smooths it, the standard deviation in degrees near n. A UserError of no file where no normal faces up.
std::shared_ptr<const Raster> raster_of_normals(const std::vector<dvec3>& normals, double width);

}  // namespace nacre
