// How far the tables are from the truth, on a fixed set of directions.
#pragma once

#include <stop_token>
#include <vector>

#include "core/bake/tables.h"
#include "core/measure/reference.h"

namespace nacre {

struct TableErrors {
    double area = 0;    // worst of area_error(), bake/tables.h
    double albedo = 0;  // worst of |R - exact|, each Fresnel factor; 0 without R
    int area_directions = 0;
    int albedo_directions = 0;
};

// Directions over the hemisphere, c from 1 down to 1e-5, azimuths that no table's row stands on.
std::vector<dvec3> probe_directions(int count);

// `reference` is that of the same design. g costs little, an R that is exact up to a second: hence two
// counts. Throws BakeCancelled when stopped.
TableErrors measure_table_errors(const Tables& tables, const Reference& reference, std::stop_token stop = {});

}  // namespace nacre
