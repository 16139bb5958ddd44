// Pictures to stamp with, and how they stand.
#pragma once

#include <glm/mat2x2.hpp>
#include <glm/vec2.hpp>
#include <memory>
#include <string>
#include <vector>

#include "core/image/raster.h"
#include "core/model/layer.h"
#include "core/model/lobe.h"

namespace nacre {

struct NamedStamp {
    std::string name;
    std::shared_ptr<const Raster> picture;    // square, white paints
    std::shared_ptr<const Raster> thumbnail;  // the same, averaged down to thumbnail_side where it is larger
};

inline constexpr int thumbnail_side = 44;  // pixels

NamedStamp named_stamp(std::string name, std::shared_ptr<const Raster> picture);

std::vector<NamedStamp> built_in_stamps();

// How an artist turns a stamp, as it is seen where it shines.
struct StampPose {
    double angle = 0;   // degrees, counterclockwise
    bool flip = false;  // left and right, before it is turned

    bool operator==(const StampPose&) const = default;
};

// From the plane about a normal `at` of the layer's frame, which the shortest rotation to the pole lays flat,
// to the stamp's picture: x right and y up where it shines, whatever the layer's rotation and tilt are.
// Facets that are tilted to one side shine on the other, so that this turns by half a circle too. Orthogonal.
glm::dmat2 stamp_from_layer(const Layer& layer, dvec3 at, const StampPose& pose);

}  // namespace nacre
