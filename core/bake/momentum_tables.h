// What can be said of the tables of shaders/multibounce/momentum.glsl once they stand.
#pragma once

#include <functional>
#include <vector>

#include "core/bake/bounce_walks.h"
#include "core/bake/stretched_grid.h"
#include "core/bake/workers.h"
#include "core/model/shading.h"

namespace nacre {

// (1/pi) of what these walks and the finished tables of `shading` would each send from somewhere to
// somewhere, cell by cell of both hemispheres: the part of all energy that is misplaced, without the noise
// that is expected of so many walks.
double misplaced_energy(const Shading<double>& shading, const BounceWalks& walks);

// At every node of R's tables the integral of M(k, k') f(k') c' dk', each colour, over a(k); see
// multibounce.glsl. `factor` gives f.
std::vector<dvec3> momentum_rows(const Shading<double>& shading, const StretchedGrid& grid,
                                 const std::function<dvec3(dvec3)>& factor, Workers& workers);

// Gives a part of each texel of the table that begins at `first` to each of those beside it. Once in every
// round of a fit (Silverman et al. 1990) it leaves what walks show again and again, and takes their noise.
void smooth_table(std::vector<double>& texels, int first, glm::ivec2 size, double part);

// Columns and rows of a momentum table.
glm::ivec2 momentum_size(const Shading<double>& shading, bool difference);

// Of each of R's tables.
int albedo_node_count(const Shading<double>& shading);

// The direction of node `i` of R's tables.
dvec3 albedo_node(const Shading<double>& shading, const StretchedGrid& grid, int i);

}  // namespace nacre
