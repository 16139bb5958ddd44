// Wavefront OBJ: surfaces of polygons as modelling programs write them.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "core/geometry/mesh.h"

namespace nacre {

inline constexpr std::size_t obj_triangles_max = 2'000'000;

// All polygons of the file as one mesh, moved and scaled as fit() does; normals and tangents made where they
// are missing. Materials are not read, nor what the format has beside polygons. What is wrong is a UserError
// that names the line. `note`, where given, becomes what was left out or made up, in one line; mostly empty.
Mesh load_obj(const std::filesystem::path& file, std::string* note = nullptr);

// The same from the text; `name` is used in errors.
Mesh parse_obj(const std::string& text, const std::string& name, std::string* note = nullptr);

}  // namespace nacre
