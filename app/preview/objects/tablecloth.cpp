// A cloth over a table.
#include "core/geometry/tablecloth.h"
#include "app/preview/object.h"

namespace nacre {

const ObjectKind tablecloth_object{
    .name = "tablecloth",
    .label = "Tablecloth",
    .about = "A cloth that has fallen over a round table. The grain is its weave.",
    .mesh = [] { return cloth_mesh(draped_cloth()); },
    .pitch = 24};

}  // namespace nacre
