// Lat-long (equirectangular) environment maps of radiance.
//
// Directions are those of the view: x right, y up, z toward the viewer. The top row touches the zenith (+y),
// the middle of the picture lies behind the object (-z), where the viewer looks, and columns run to the right
// there
// (+x): the picture is seen from inside, unmirrored. With u, v in [0, 1] from the left and from the top
//
//   d = (sin t sin p, cos t, -sin t cos p),   t = pi v,   p = 2 pi (u - 1/2)
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

namespace nacre {

struct LatLong {
    int width = 0, height = 0;        // texels
    std::vector<glm::vec3> radiance;  // linear Rec. 709, >= 0 and finite; rows from the top
};

glm::dvec3 lat_long_direction(glm::dvec2 place);

// Its inverse; `direction` has length 1. At zenith and nadir u is 1/2.
glm::dvec2 lat_long_place(glm::dvec3 direction);

// Steradians of one texel of a row.
double texel_solid_angle(const LatLong& picture, int row);

// Bilinear between texel centres: round the horizon without a seam, constant beyond the first and the last
// row's centres.
glm::dvec3 radiance_at(const LatLong& picture, glm::dvec2 place);

}  // namespace nacre
