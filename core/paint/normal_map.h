// p(h) of a surface from a picture of its normals or of its heights.
#pragma once

#include <memory>

#include "core/design/design.h"
#include "core/exchange/picture.h"
#include "core/model/lobe.h"

namespace nacre {

// A tangent-space normal map: red x, green y (up), blue z. A picture in [0, 1] means 2 c - 1; one that holds
// negative values is read as it is. Pixels without a direction, and those that face down, are left out.
std::vector<dvec3> normals_of_map(const ColourPicture& picture);

// Of a height map that is periodic and whose heights, the mean of the colours, are `depth` picture breadths
// from black to white, from white to black where that is negative: central differences.
std::vector<dvec3> normals_of_heights(const ColourPicture& picture, double depth);

// The share of the facets' area on each normal, as a painted layer's raster with a largest value of 1. Each
// normal stands for the same area as seen from above, so for 1/n.z of facets; no more than for 50. `width`
// smooths it, the standard deviation in degrees near n. A UserError of no file where no normal faces up.
std::shared_ptr<const Raster> raster_of_normals(const std::vector<dvec3>& normals, double width);

}  // namespace nacre
