// The lobes a layer can have, and how one becomes another.
#pragma once

#include <cstddef>
#include <span>

#include "core/design/design.h"

namespace nacre::ui {

// Names in the order of the alternatives of `Lobe`.
std::span<const char* const> lobe_names();
const char* lobe_explanation(std::size_t kind);

// A lobe of the kind with its default parameters.
Lobe default_lobe(std::size_t kind);

// The same highlight as nearly as the other kind can have it: widths are carried over.
Lobe converted_lobe(const Lobe& lobe, std::size_t kind);

// What a list shows for a layer: its own name, or its lobe's.
const char* layer_title(const Layer& layer);

}  // namespace nacre::ui
