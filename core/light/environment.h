// What surrounds the object, ready to be looked up and to be drawn from.
#pragma once

#include <memory>
#include <string>

#include "core/light/direction_order.h"
#include "core/light/lat_long.h"

namespace nacre {

// By latitude and longitude like the picture, in cells on which it is constant: what light is drawn with.
struct LightDensity {
    int width = 0, height = 0;
    std::vector<float>
        values;  // per steradian; its integral is 1, and it is positive wherever light comes from

    double at(glm::dvec2 place) const;
};

struct Environment {
    std::string name;  // of a procedural one, or the file
    LatLong picture;
    LightDensity density;
    DirectionOrder light;  // drawn from `density`
};

std::shared_ptr<const Environment> make_environment(std::string name, LatLong picture);

}  // namespace nacre
