// Drawn by its formula, without a mesh.
#include "app/preview/object.h"

namespace nacre {

const ObjectKind sphere_object{.name = "sphere",
                               .label = "Sphere",
                               .about = "Every direction once. The grain runs around its axis.",
                               .mesh = nullptr,
                               .pitch = 0};

}  // namespace nacre
