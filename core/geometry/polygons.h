// Makes a mesh of a file's polygons: corners share positions, and normals and tangents may
// be missing.
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <vector>

#include "core/geometry/mesh.h"

namespace nacre {

constexpr int absent = -1;

struct Triangles {
    struct Corner {
        int position = 0;
        int normal = absent;
        int uv = absent;
    };
    std::vector<glm::dvec3> positions, normals;
    std::vector<glm::dvec2> uvs;
    std::vector<std::array<Corner, 3>> faces;  // indices within the fields above
};

inline constexpr double coordinate_max = 1e100;  // the size of a coordinate that mesh_of() computes with

// Missing normals are those of the faces around a position that lie within `crease` degrees, weighted by
// their angle there (Thuermer and Wuethrich 1998): edges that are sharper stay sharp. Tangents run along
// increasing u (Lengyel 2001); they are 0 where u is missing or does not vary. Faces without area are left
// out; the rest is moved and scaled as fit() does. No coordinate is larger than coordinate_max.
Mesh mesh_of(const Triangles& triangles, double crease = 50);

}  // namespace nacre
