// The row above the preview: what of the BRDF it shows.
#pragma once

#include "core/shading/term.h"

namespace nacre::ui {

// The terms of a design of these kinds. `factors` false: a model without them is shown, and only light can be
// chosen. An expert sees the factors too.
void term_bar(Term& term, const ShadingKinds& kinds, bool factors, bool expert);

}  // namespace nacre::ui
