// The list of layers, and what can be done to one of them.
#pragma once

#include <vector>

#include "ui/layers_panel.h"

namespace nacre::ui {

enum class LayerAction { none, rename, duplicate, remove, up, down, cut, copy, paste };

// Whether an action can be done to a layer, given how many there are.
bool possible(LayerAction action, std::size_t layer, std::size_t count);

// Does it to the chosen layer, if it is possible; what the clipboard has part in is left to the caller, as
// `view.asked`. Returns whether the layers changed.
bool act(LayerAction action, LayersView& view, std::vector<Layer>& layers);

// A line for each layer: a click chooses it, a double click renames it, a drag carries it to where a line
// stands between two others, the right button opens a menu. Returns whether the layers changed.
bool layer_list(LayersView& view, std::vector<Layer>& layers);

}  // namespace nacre::ui
