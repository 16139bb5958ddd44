// How far the tables are from the truth, on a fixed set of directions.
#pragma once

#include <stop_token>
#include <vector>

#include "core/bake/tables.h"
#include "core/measure/reference.h"

namespace nacre {

// Directions over the hemisphere, c from 1 down to 1e-5, azimuths that no table's row stands on.
std::vector<dvec3> probe_directions(int count);

struct ProbeCounts {
    int area = 200;
    int albedo = 8;  // an R that is exact may take a second
};

// Against the exact g and R; `reference` is that of the same design. Without baked R that is not measured.
// Throws BakeCancelled when stopped.
TableErrors measure_table_errors(const Tables& tables, const Reference& reference, std::stop_token stop = {},
                                 const ProbeCounts& probes = {});

// R as the tables hold it, with F = 1 and with each Fresnel factor that is baked; k.z >= 0.
AlbedoValues baked_albedo(const Tables& tables, dvec3 k);

// Worst and root mean square.
TableError summarise(const std::vector<double>& errors);

}  // namespace nacre
