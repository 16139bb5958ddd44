// A design's surface and layers as initialisers of a language that looks like C.
#pragma once

#include <string>
#include <string_view>

#include "core/formats/glsl_tree.h"
#include "core/model/shading.h"

namespace nacre {

// Numbers with the digits of a double, or the shortest that read back as the same float.
enum class Digits { of_float, of_double };

std::string digits_of(double value, Digits digits);

// Braces with a field a line, of the fields that the program's struct has.
std::string surface_values(const Shading<double>& shading, const GlslProgram& program, Digits digits);
// The same of every layer, with commas between them.
std::string layer_values(const Shading<double>& shading, const GlslProgram& program, Digits digits);

}  // namespace nacre
