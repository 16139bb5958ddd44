// An environment map, ready to be looked up and sampled.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/image/lat_long.h"
#include "core/light/direction_order.h"

namespace nacre {

struct Environment {
    std::string name;  // of a procedural one, or the file
    LatLong picture;
    // Directions by the mean of the picture's three colours, its bilinear rule included. Where all is dark
    // they are any.
    DirectionOrder light;
    double brightness = 0;           // the integral of that mean over the sphere
    std::vector<std::string> notes;  // what a file's reader changed or left out, in words

    // The density, per steradian, that `light` has where the picture has this radiance.
    double light_density(glm::dvec3 radiance) const {
        return brightness > 0 ? (radiance.x + radiance.y + radiance.z) / (3 * brightness) : 0;
    }
};

std::shared_ptr<const Environment> make_environment(std::string name, LatLong picture,
                                                    std::vector<std::string> notes = {});

}  // namespace nacre
