// Radiance 1 from everywhere.
#include "core/light/procedural.h"

namespace nacre {

const ProceduralEnvironment furnace_environment{
    .name = "furnace",
    .label = "Furnace",
    .about = "Light from everywhere, as strong from each direction: what reflects all of it vanishes.",
    .width = 64,
    .picture = [](int width) {
        return painted_environment(width, [](glm::dvec3) { return glm::dvec3{1}; });
    }};

}  // namespace nacre
