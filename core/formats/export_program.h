// All of a design's shader text as a syntax tree: the BRDF, its albedo, and how to sample it.
#pragma once

#include <vector>

#include "core/bake/tables.h"
#include "core/formats/glsl_tree.h"

namespace nacre {

// Functions of the tree that a caller needs: brdf(k1, k2), where R is baked `albedo`(k1's Direction),
// drawn_direction(k2, u) and drawn_density(k1, k2). It leaves out `data`, `surface`, `layers`, `layer_count`
// and LARGEST, which a writer defines.
struct ExportProgram {
    GlslProgram tree;
    const char* albedo;       // empty where R is not baked
    std::vector<float> data;  // of the tables, then what samples are drawn by
};

ExportProgram export_program(const Tables& tables);

}  // namespace nacre
