// The error of the paper's table of g (Ashikhmin 2000, sec. 5.2).
#pragma once

#include <stop_token>

#include "core/bake/tables.h"
#include "core/study/grid_table.h"

namespace nacre {

// Where the paper's 200 points may lie. It says neither how many there are along theta nor whether an
// anisotropic Gaussian has them over the hemisphere or over the quarter that suffices.
enum class PaperPoints { polar_20_quarter, polar_10_quarter, polar_10_hemisphere };

// g as stored there, exact at the points, of a p with two mirror planes through the axes.
GridTable paper_table(const FacetDistribution& p, PaperPoints points, const std::stop_token& stop);

struct WorstError {
    double error = 0;           // relative, as area_error()
    double theta = 0, phi = 0;  // degrees: where
};

// The largest of a table, over a quarter of the hemisphere at steps of half a degree and less.
WorstError worst_error(const Tables& tables, const GridTable& table, const std::stop_token& stop);
WorstError worst_error(const Tables& tables, const std::stop_token& stop);  // of the tables themselves

}  // namespace nacre
