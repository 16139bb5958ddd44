#pragma once

#include <string>

#include "ui/widgets.h"

namespace nacre::ui {

// The bare field of a slider, over the width set for the next item and without its label: a bar that is
// filled from its origin. Dragging stays between the ends of the slider; Ctrl+click types any number from
// `least` to `most`, and what is none is refused and said; a double click or the context menu brings `reset`.
// Without `marked` no line stands at the bar's end, where it would cross a text that fills the field. Returns
// whether the value changed.
bool slider_field(const SliderSpec& spec, const std::string& name, double& value, bool marked = true);

// A box that a click types into, of the same numbers; `low`, `high` and `reset` have no meaning there.
bool number_field(const SliderSpec& spec, const std::string& name, double& value);

}  // namespace nacre::ui
