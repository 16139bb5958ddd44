// Wavefront OBJ: surfaces of polygons as modelling programs write them.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "core/geometry/mesh.h"

namespace nacre {

inline constexpr std::size_t obj_triangles_max = 2'000'000;
inline constexpr std::size_t obj_corners_max = 256;  // of one face

// All objects of the file as one mesh, moved and scaled as fit() does; normals and tangents made where they
// are missing. What is wrong is a UserError that names the line. Materials are not read.
Mesh load_obj(const std::filesystem::path& file);

// The same from the text; `name` stands in errors.
Mesh parse_obj(const std::string& text, const std::string& name);

}  // namespace nacre
