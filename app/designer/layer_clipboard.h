// Layers on the system's clipboard, as the text of a design that holds them: they go from one design or
// window to another, and into a text editor. Files of pictures are named by absolute paths; pictures that are
// in the design are in the text.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/model/layer.h"

namespace nacre {

// What one request to an X server can hold; a larger one would end the program.
inline constexpr std::size_t clipboard_bytes_max = std::size_t{15} << 20;

// A UserError where the text is too large or a path cannot be written down.
std::string layer_text(const Layer& layer);

// The layers that a text holds, `room` at most. Whatever is wrong is a UserError; foreign text is one of few
// words.
std::vector<Layer> layers_of_text(std::string_view text, std::size_t room);

struct Designer;

// Of the chosen layer. What cannot be done is told in the status line.
void cut_layer(Designer& designer);
void copy_layer(Designer& designer);
void paste_layer(Designer& designer);  // after it; what is pasted is chosen

}  // namespace nacre
