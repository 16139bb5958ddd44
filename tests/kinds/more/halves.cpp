// Light from the upper half alone.
#include "core/light/procedural.h"

namespace nacre {

const ProceduralEnvironment halves_environment{
    .name = "halves",
    .label = "Halves",
    .about = "Light from the upper half alone.",
    .width = 64,
    .picture = [](int width) {
        return painted_environment(width, [](glm::dvec3 d) { return glm::dvec3{d.y > 0 ? 1.0 : 0.1}; });
    }};

}  // namespace nacre
