// The tables of light that bounces between the facets, beside those of R; see
// shaders/shared/multibounce.glsl.
#pragma once

#include <optional>

#include "core/bake/momentum_fit.h"
#include "core/bake/tables.h"

namespace nacre {

// What random walks say of a design, whatever its colours with Schlick's Fresnel.
struct BounceFit {
    BounceWalks walks;                       // without their pairs
    std::optional<MomentumTables> momentum;  // fitted to them
    std::optional<double> misplaced;         // measured on other walks
    double seconds = 0;                      // that it took to make
};

// Appends to `tables`, which are finished but for these, all that the bounces of `model` need; rank_one
// stands for a model that is to be fitted, where not `fitted`. `fit`: of the same p, masking and Fresnel
// model, or nothing: then it is made. Throws BakeCancelled.
void add_bounce_tables(Tables& tables, const StretchedGrid& grid, const Multibounce& model, bool fitted,
                       std::optional<BounceFit>& fit, Workers& workers);

}  // namespace nacre
