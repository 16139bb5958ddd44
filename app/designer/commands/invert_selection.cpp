#include "app/designer/command.h"

namespace nacre {

const Command invert_selection_command{
    .info = {.menu = "Select",
             .label = "Invert selection",
             .keys = "Ctrl+Shift+I",
             .about = "Select what is not selected."},
    .enabled = [](const Designer& designer) { return designer.canvas.state.selection != nullptr; },
    .perform =
        [](Designer& designer, std::size_t) {
            ui::CanvasState& canvas = designer.canvas.state;
            canvas.selection = inverted(*canvas.selection);
        }};

}  // namespace nacre
