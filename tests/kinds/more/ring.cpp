// A thin ring.
#include "app/preview/object.h"
#include "core/geometry/shapes.h"

namespace nacre {

const ObjectKind ring_object{.name = "ring",
                             .label = "Ring",
                             .about = "A thin ring.",
                             .mesh = [] { return torus(0.15f); },
                             .pitch = 50};

}  // namespace nacre
