// What one frame shows: made once, after the frame's input has done its work and before anything of it is
// drawn, so that no part depends on which is drawn first.
#pragma once

#include <memory>

#include "core/bake/tables.h"
#include "core/design/design.h"
#include "core/model/facet_distribution.h"

namespace nacre {

struct Frame {
    Design design;                               // with the layers that are shown
    std::shared_ptr<const FacetDistribution> p;  // of it; null where it has no facets
    int revision = 0;                            // rises whenever p changes
    std::shared_ptr<const Tables> tables;        // the newest, of this design or of one before
    bool settled = true;                         // nothing moves p: final tables are worth their time
};

}  // namespace nacre
