// The layers of the distribution: a list, and the chosen layer's parameters.
#pragma once

#include <cstddef>
#include <string>

#include "core/design/design.h"

namespace nacre::ui {

// What the panel remembers between frames; no part of the document.
struct LayersView {
    std::size_t chosen = 0;
};

// Returns whether the distribution changed.
bool layers_panel(LayersView& view, Distribution& distribution);

// The parameters of one layer.
bool layer_editor(Layer& layer);
bool lobe_editor(Lobe& lobe);

// "in the design, 256 x 256", or the file's name in place of the first part.
std::string picture_text(const Picture& picture);

}  // namespace nacre::ui
