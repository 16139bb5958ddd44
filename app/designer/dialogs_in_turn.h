// Which of the dialogs and questions is on the screen.
#pragma once

#include "app/designer/designer.h"

namespace nacre {

// Draws one of those that are open, and acts on its answer.
void draw_dialogs(Designer& designer);

}  // namespace nacre
