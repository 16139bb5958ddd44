// The tables of shaders/multibounce/momentum.glsl, fitted to random walks.
#pragma once

#include <vector>

#include "core/bake/bounce_walks.h"
#include "core/bake/stretched_grid.h"
#include "core/bake/workers.h"
#include "core/model/shading.h"

namespace nacre {

struct MomentumTables {
    int nodes = 0;                       // of all but the first, from 0 to 2
    std::vector<float> row;              // at R's nodes, over the amplitude there
    std::vector<float> amplitude;        // over one direction
    std::vector<float> sum, difference;  // over the sum and the difference of both
    double error = 0;                    // worst of what they bring, between R's nodes
};

// Maximum likelihood of the walks' exits over qs and qd; `a` scaled so that from every direction as much
// comes back as is to (Sinkhorn & Knopp 1967), as far as its few nodes can, and from none more: the rest is
// spread evenly. `shading` holds the tables of g and R on the grid `grid`. Throws BakeCancelled.
MomentumTables fit_momentum(const Shading<double>& shading, const StretchedGrid& grid,
                            const BounceWalks& walks, Workers& workers);

}  // namespace nacre
