// From a design to its tables.
#pragma once

#include <functional>
#include <memory>
#include <stop_token>
#include <vector>

#include "core/bake/tables.h"
#include "core/bake/workers.h"
#include "core/design/design.h"

namespace nacre {

struct BakeOptions {
    Quality quality = Quality::final;
    bool albedo = false;  // R is wanted even if no diffuse term reads it
    bool fit_bounces =
        true;         // else what a model would fit to random walks is spread evenly; a draft never fits
    int threads = 0;  // 0, or more than the machine has: all of them; the result is the same for any
    double tolerance = 1e-3;  // what a final bake keeps the errors of g (relative) and R (absolute) under
    std::optional<TableSize> size = {};     // exactly these nodes, whatever the error
    std::optional<Symmetry> symmetry = {};  // use at most this symmetry
};

// The bakes that show a design sooner and better: a draft, the final tables, and where the design has them
// those that are fitted to random walks, which takes a second or two.
std::vector<BakeOptions> bake_steps(const Design& design);

// Throws UserError (with an empty file name) when the design holds no facets that face up, and BakeCancelled
// soon after `stop` is requested. `progress` gets rising values in [0, 1] from the calling thread.
std::shared_ptr<const Tables> bake(const Design& design, const BakeOptions& options = {},
                                   std::stop_token stop = {},
                                   const std::function<void(double)>& progress = {});

}  // namespace nacre
