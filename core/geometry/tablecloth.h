// The tablecloth of the preview: a square cloth draped over a round table.
#pragma once

#include <vector>

#include "core/geometry/mesh.h"

namespace nacre {

// Points of a square grid: warp threads run along rows, weft threads along columns.
struct Cloth {
    int side = 0;  // points a side
    std::vector<glm::dvec3> points;

    const glm::dvec3& point(int column, int row) const {
        return points[static_cast<std::size_t>(row * side + column)];
    }
};

// The cloth of tablecloth.obj, metres: y is up, and 0 on the table.
Cloth draped_cloth();

// The smooth surface whose control points the cloth's are, scaled as fit() does. Tangents run along the warp.
Mesh cloth_mesh(const Cloth& cloth);

}  // namespace nacre
