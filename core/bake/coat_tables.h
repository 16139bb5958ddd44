// The tables of a coat; see shaders/shared/coat.glsl.
#pragma once

#include <optional>
#include <vector>

#include "core/bake/stretched_grid.h"
#include "core/bake/tables.h"
#include "core/bake/workers.h"

namespace nacre {

// Of the coat alone, whatever lies beneath.
struct CoatLobe {
    std::size_t kind;  // its place in Coat
    ShaderCoat coat;
    std::vector<float> albedo;  // R_c
    std::shared_ptr<const FacetDistribution> facets;
};

// Appends to `tables`, which are finished but for these and know nothing of the coat before. `known`: of the
// last bake, or nothing; it is made again where the coat has changed. Throws BakeCancelled.
void add_coat_tables(Tables& tables, const StretchedGrid& grid, const Coat& coat,
                     std::optional<CoatLobe>& known, Workers& workers);

}  // namespace nacre
