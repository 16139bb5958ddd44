// Luminance of a colour.
#pragma once

#include <glm/vec3.hpp>

namespace nacre {

// Of linear Rec. 709 (ITU-R BT.709-6, sec. 3.2).
inline double luminance(const glm::dvec3& c) { return 0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z; }

}  // namespace nacre
