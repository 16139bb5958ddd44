// Errors of the tables against the reference, on a fixed set of directions.
#pragma once

#include <functional>
#include <stop_token>
#include <vector>

#include "core/bake/tables.h"
#include "core/verify/reference.h"

namespace nacre {

// Directions over the hemisphere, c from 1 down to 1e-5, azimuths that are on no table's row.
std::vector<dvec3> probe_directions(int count);

struct ProbeCounts {
    int area = 200;
    int albedo = 8;  // at most; fewer, but at least 4, where they take more than 12 s of processor time
};

// Against the exact g and R; `reference` is that of the same design. Without baked R that is not measured.
// Throws BakeCancelled when stopped. `progress` gets rising values in [0, 1] from the calling thread.
TableErrors measure_table_errors(const Tables& tables, const Reference& reference, std::stop_token stop = {},
                                 const ProbeCounts& probes = {},
                                 const std::function<void(double)>& progress = {});

// The most that the bake's own claim allows on directions that are not the bake's: the tolerance or, where
// the tables' size forbade that, 1.25 times the worst error that the bake measured itself.
double allowed_error(const TableError& claim, double tolerance);

}  // namespace nacre
