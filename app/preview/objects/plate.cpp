// A tile.
#include "app/preview/object.h"
#include "core/geometry/shapes.h"

namespace nacre {

const ObjectKind plate_object{
    .name = "plate",
    .label = "Plate",
    .about = "A tile, a little domed, with round edges. The grain runs from left to right.",
    .mesh = [] { return plate(); },
    .pitch = 0};

}  // namespace nacre
