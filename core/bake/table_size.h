// How many nodes the tables have: chosen from the error that a first, small table shows.
#pragma once

#include "core/bake/symmetry.h"

namespace nacre {

enum class Quality { draft, final };

// Nodes of the tables: of g along theta (w) and azimuth (psi), of R along theta (v) and azimuth (rho). One
// azimuth for an isotropic p, two or more otherwise; two or more along theta.
struct TableSize {
    int w = 0, psi = 0, v = 0, rho = 0;

    bool operator==(const TableSize&) const = default;
};

// A draft's own size, which is not refined, and where the refining of a final bake begins.
TableSize first_size(Symmetry symmetry, Quality quality);

// Cells along the azimuth of a table with this many nodes there: a full turn closes on its first row, a
// mirrored part of one ends on rows of its own, and a single row stands for all of them.
int azimuth_cells(int nodes, Symmetry symmetry);

// Nodes along theta and along azimuth of one table.
struct TableNodes {
    int polar, azimuth;

    bool operator==(const TableNodes&) const = default;
};

// The fewest nodes that promise an error under `target`, from the errors that `now` shows along each axis: of
// linear interpolation they fall with the square of the spacing, and they add up. Within `limit` nodes in all
// and four times as many cells as now along an axis; the smallest error where none keeps under the target.
TableNodes better_nodes(TableNodes now, Symmetry symmetry, double error_polar, double error_azimuth,
                        double target, int limit);

}  // namespace nacre
