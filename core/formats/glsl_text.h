// Parts of the GLSL that the exports write.
#pragma once

#include <string>
#include <string_view>

#include "core/bake/tables.h"
#include "core/design/design.h"
#include "core/formats/sampling_table.h"

namespace nacre {

// Shortest digits that read back as the same float, with the point that GLSL wants.
std::string glsl_number(double value);

// The parameters of shaders/shared/parameters.glsl as constants: `surface`, `layer_count` and `layers`.
std::string surface_constants(const Shading<double>& shading);

// `fetch` and the sampler that it reads, which is named `name`: one float a texel, rows of 1024.
std::string sampler_fetch(std::string_view name);

// The text with another word in the place of each `word`.
std::string with_word(std::string text, std::string_view word, std::string_view other);

std::string without_comments(const std::string& text);

// A self-contained text that defines PREFIX_brdf and, where R is baked, PREFIX_albedo; see glsl_export.h.
// Every name that it defines outside a function gets the prefix and an underscore. `data` declares the tables
// and defines `fetch`; `about_data` are the lines of the head that tell of it. With a sampling table, which
// stands behind Tables::data, it defines PREFIX_sample and PREFIX_pdf too.
std::string glsl_function(const Design& design, const Tables& tables, const std::string& prefix,
                          const std::string& data, const std::string& about_data = {},
                          const SamplingTable* sampling = nullptr);

}  // namespace nacre
