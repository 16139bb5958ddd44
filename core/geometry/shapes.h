// Shapes that a formula gives, each with its exact normals and tangents.
#pragma once

#include "core/geometry/mesh.h"

namespace nacre {

// A ring about the y axis: a circle of radius `tube` whose centre runs on a circle of radius 1 - tube.
// Tangents run around the axis.
Mesh torus(float tube = 0.36f);

// A square tile that faces z, a little domed so that a highlight is seen on it, its edges and corners round.
// Tangents run along x.
struct PlateShape {
    float core = 0.62f;  // half the side of the part that is not rounded
    float round = 0.1f;  // radius of the edges
    float dome = 0.6f;   // curvature in the middle: z falls by dome (x^2 + y^2)/2
};
Mesh plate(const PlateShape& shape = {});

}  // namespace nacre
