// The tables of facets that are matt themselves; see shaders/shared/matt_facets.glsl.
#pragma once

#include <optional>
#include <vector>

#include "core/bake/facet_terms.h"
#include "core/bake/tables.h"

namespace nacre {

// Whatever the albedo is.
struct FacetTables {
    FacetShape shape{};
    std::vector<float> values;  // of each term, then E
    double even = 0;            // 1/(pi <1 - E>)
    double second = 0;   // of the light that the first bounce keeps, the part that leaves after the second
    TableError error;    // of facet_error()
    double seconds = 0;  // that they took to make
};

// Appends to `tables`, which are finished but for these. `known`: of the same p, masking and quality, or
// nothing: then they are made. Throws BakeCancelled.
void add_facet_tables(Tables& tables, const StretchedGrid& grid, std::optional<FacetTables>& known,
                      Workers& workers);

// Error of what the tables hold of two directions, given V of the uncorrelated masking: absolute, of N Q/(K1
// K2), which is V where p stands upright and less where its facets turn away.
double facet_error(const Shading<double>& shading, dvec3 k1, dvec3 k2, double exact);

}  // namespace nacre
