// One self-contained GLSL function, tables and all, for other people's shaders.
#pragma once

#include <string>

#include "core/bake/tables.h"
#include "core/design/design.h"

namespace nacre {

// GLSL 3.30 text that defines `vec3 PREFIX_brdf(vec3 k1, vec3 k2)` (1/sr; local frame, z = normal) and, where
// R is baked, `vec3 PREFIX_albedo(vec3 k)`. It needs no uniform and no texture: tables and pictures are
// constant arrays. Every name that it defines begins with PREFIX_, so that several designs fit into one
// shader.
std::string glsl_export(const Design& design, const Tables& tables, const std::string& prefix = "nacre");

}  // namespace nacre
