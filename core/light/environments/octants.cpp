// A different colour from each octant, to see that nothing is mirrored.
#include "core/light/procedural.h"

namespace nacre {
namespace {

glm::dvec3 octant_colour(glm::dvec3 d) {
    return {d.x > 0 ? 1.0 : 0.1, d.y > 0 ? 1.0 : 0.1, d.z > 0 ? 1.0 : 0.1};
}

}  // namespace

const ProceduralEnvironment octants_environment{
    .name = "octants",
    .label = "Octants",
    .about =
        "A different colour from each octant: red from the right, green from above, blue from the viewer.",
    .width = 256,
    .picture = [](int width) { return painted_environment(width, octant_colour); }};

}  // namespace nacre
