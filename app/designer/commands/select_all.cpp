#include "app/designer/command.h"

namespace nacre {

const Command select_all_command{
    .info = {.menu = "Select", .label = "Select all", .keys = "Ctrl+A", .about = "Select the whole canvas."},
    .perform = [](Designer& designer, std::size_t) { designer.canvas.state.selection = select_all(); }};

}  // namespace nacre
