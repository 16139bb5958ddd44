// The GLSL files of this folder, compiled into the program.
#pragma once

#include <string_view>

namespace nacre {

// The text of a file by its path below shaders/, for instance "shared/fresnel.glsl"; empty when there
// is no such file.
std::string_view shader_text(std::string_view name);

}  // namespace nacre
