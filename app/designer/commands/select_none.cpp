#include "app/designer/command.h"

namespace nacre {

const Command select_none_command{
    .info = {.menu = "Select",
             .label = "Select none",
             .keys = "Ctrl+Shift+A",
             .about = "Nothing is selected: the tools work everywhere."},
    .enabled = [](const Designer& designer) { return designer.canvas.state.selection != nullptr; },
    .perform = [](Designer& designer, std::size_t) { designer.canvas.state.selection.reset(); }};

}  // namespace nacre
