// Reads the part of GLSL in which the shared mathematics is written.
#pragma once

#include <string_view>
#include <vector>

#include "core/formats/glsl_tree.h"

namespace nacre {

// `globals` are names that the text reads and does not define; an array's type ends in []. Conditions that
// are constant, and what they leave out, are resolved. Throws std::logic_error at what it does not know:
// the text is a part of the program.
GlslProgram parse_glsl(std::string_view text, const std::vector<GlslVariable>& globals);

}  // namespace nacre
