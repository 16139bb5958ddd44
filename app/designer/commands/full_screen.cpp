#include "app/designer/command.h"

namespace nacre {

const Command full_screen_command{
    .info = {.menu = "View",
             .label = "Full screen",
             .keys = "F11",
             .about = "The window over the whole monitor."},
    .checked = [](const Designer& designer) { return designer.full_screen; },
    .perform = [](Designer& designer, std::size_t) { designer.full_screen = !designer.full_screen; }};

}  // namespace nacre
