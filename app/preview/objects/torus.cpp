// A ring.
#include "app/preview/object.h"
#include "core/geometry/shapes.h"

namespace nacre {

const ObjectKind torus_object{
    .name = "torus",
    .label = "Torus",
    .about = "Curved both ways, like a saddle inside. The grain runs around the ring.",
    .mesh = [] { return torus(); },
    .pitch = 50};

}  // namespace nacre
