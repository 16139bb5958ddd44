// The web page's shader, put together from the shaders of the preview.
#pragma once

#include <string>
#include <string_view>

#include "core/model/shading.h"

namespace nacre {

// GLSL ES 3.00: core/formats/web/head.frag and `main` of the same folder, with their parts in place.
// "page.frag" draws the picture, with one light and no ambient light; "light.frag" what an environment adds.
std::string web_fragment_shader(const Shading<double>& shading, std::string_view main);
std::string web_vertex_shader();

// `text` with `to` in the place of each `from`, of which there must be one: else a std::logic_error.
std::string with_text(std::string text, std::string_view from, std::string_view to);

}  // namespace nacre
