// The GLSL function of a design of any size: its tables are a texture.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/bake/tables.h"
#include "core/design/design.h"

namespace nacre {

// As glsl_export(), but the numbers come from `uniform sampler2D PREFIX_data`, a texture of 32-bit floats
// (R32F) without filtering or mipmaps that holds sampler_data(). It is also GLSL ES 3.00, where the program
// has set precisions. It has PREFIX_sample and PREFIX_pdf besides.
std::string glsl_sampler_text(const Design& design, const Tables& tables, const std::string& prefix);

// What that texture holds: the tables, and behind them what samples are drawn by.
std::vector<float> sampler_data(const Tables& tables);

// Numbers as a texture's rows of 1024 little-endian 32-bit floats; the last row ends in zeros.
std::string texture_bytes(std::span<const float> numbers);

// Rows of such a texture.
int texture_rows(std::size_t numbers);

// A 32-bit float as little-endian bytes.
void add_float(std::string& bytes, float value);

}  // namespace nacre
