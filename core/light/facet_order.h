// The facets of a design's p, ordered for drawing.
#pragma once

#include "core/light/direction_order.h"
#include "core/model/facet_distribution.h"

namespace nacre {

// In the surface's frame, lobe after lobe, each along Hilbert's curve in its own stretched coordinates:
// `side` x `side` cells a hemisphere, a power of two, in each of which p counts as constant. 256 resolve
// every smooth lobe.
DirectionOrder order_facets(const FacetDistribution& distribution, int side);

}  // namespace nacre
