// What a design needs of the bake and of the shader, and what it can do without.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/bake/symmetry.h"
#include "core/bake/table_size.h"
#include "core/design/design.h"
#include "core/model/shading.h"

namespace nacre {

// What a bake or a shader can do without.
enum class Part {
    symmetric_nodes,  // of every table
    albedo,
    fresnel_table,
    fresnel_colours,  // a Fresnel table for each
    pictures,
    fresnel,
    masking,  // of another model
    diffuse
};

struct Omission {
    Part part;
    std::string what;
    std::string why;
};

struct BakePlan {
    DistributionSymmetry symmetry;
    Quality quality = Quality::final;
    TableSize nodes;
    bool albedo = false;     // R(k) with F = 1, and with the design's Fresnel factor
    int fresnel_tables = 0;  // 0: F = 1 alone; 1: Schlick's weight; 3: exact, a colour each
    std::vector<Omission> omissions;
};

struct PlanOptions {
    Quality quality = Quality::final;
    bool albedo = false;  // R is wanted even if no diffuse term reads it (ambient light, the `tables` verb)
    std::optional<TableSize> size = {};     // exactly so many nodes
    std::optional<Symmetry> symmetry = {};  // use no more of it than this, though p has more
};

BakePlan plan_bake(const Design& design, const PlanOptions& options);

}  // namespace nacre
