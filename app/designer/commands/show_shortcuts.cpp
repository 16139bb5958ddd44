#include "app/designer/command.h"

namespace nacre {

const Command show_shortcuts_command{
    .info = {.menu = "Help",
             .label = "Shortcuts",
             .keys = "F1",
             .about = "All keys and what the mouse does."},
    .perform = [](Designer& designer, std::size_t) { designer.sheet = true; }};

}  // namespace nacre
