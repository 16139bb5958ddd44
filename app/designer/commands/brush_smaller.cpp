#include "app/designer/command.h"
#include "ui/canvas_toolbar.h"

namespace nacre {

const Command brush_smaller_command{
    .info = {.menu = "Canvas",
             .label = nullptr,
             .keys = "[",
             .also = ",",
             .about = "A smaller brush.",
             .repeats = true},
    .perform = [](Designer& designer, std::size_t) { ui::resize_brush(designer.canvas.state, -1); }};

}  // namespace nacre
