// What shaders/export/sample.glsl draws directions by, for exports of a design.
#pragma once

#include <string>
#include <vector>

#include "core/bake/tables.h"

namespace nacre {

struct SamplingTable {
    int rows = 0;
    int columns = 0;            // 1 where p is isotropic
    int stride = 0;             // from the bounds of one row to those of the next
    double cosine_share = 0;    // how often a cosine about n is drawn
    std::vector<float> values;  // as sample.glsl says; to stand behind Tables::data
};

// Of any p: made of facets that its own sampler draws, always the same for the same design.
SamplingTable sampling_table(const Tables& tables);

// GLSL to stand behind shared_mathematics(): `real3 drawn_direction(real3 k2, real3 u)` and `real
// drawn_density(real3 k1, real3 k2)`. `offset`: of the table's first value in the data.
std::string sampling_mathematics(const Tables& tables, const SamplingTable& table, std::size_t offset);

// GLSL with the names that a caller uses, to stand behind all else once it has its prefix:
// `vec4 PREFIX_sample(vec3 k2, vec3 u)`, a direction and its density, and `float PREFIX_pdf(vec3 k1, vec3
// k2)`.
std::string sampling_calls(const std::string& prefix);

}  // namespace nacre
