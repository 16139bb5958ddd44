#include "app/designer/command.h"
#include "ui/canvas_paint.h"

namespace nacre {

const Command fill_selection_command{
    .info = {.menu = "Select",
             .label = "Fill selection",
             .keys = "Shift+Backspace",
             .about = "Fill what is selected with the brush's value, as it combines.",
             .begins_group = true},
    .enabled = [](const Designer& designer) { return designer.canvas.state.selection != nullptr; },
    .perform =
        [](Designer& designer, std::size_t) {
            const ui::CanvasState& canvas = designer.canvas.state;
            ui::paint_selection(canvas, canvas.brush, designer.document.design.distribution,
                                designer.layers.chosen);
        }};

}  // namespace nacre
