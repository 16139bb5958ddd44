// The history of the document as a panel.
#pragma once

#include "app/designer/document.h"

namespace nacre {

// Draws it into the current Dear ImGui window; a click goes to a step.
void draw_history(Document& document);

}  // namespace nacre
