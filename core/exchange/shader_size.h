// How large a variant's share of the shader is, counted from its text.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/exchange/shader_variant.h"

namespace nacre {

// The text that the GLSL preprocessor leaves of `text` under its own #define and #if lines: without comments
// and directives. Conditions are names and whole numbers joined by !, && and ||.
std::string preprocessed(std::string_view text);

// Statements in the bodies of functions: declarations, assignments, returns, and the conditions of if, for
// and while, but not of those that the variant fixes as true or false.
int count_statements(std::string_view preprocessed_text);

// Of the BRDF, its lobes and its look-up, without a scene: GLSL statements after the preprocessor. `also`
// names definitions of the variant that are turned on in addition, for instance "VISIBILITY_SMITH".
int shader_statements(const ShaderVariant& variant, const std::vector<std::string>& also = {});

}  // namespace nacre
