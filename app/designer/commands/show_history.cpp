#include "app/designer/command.h"

namespace nacre {

const Command show_history_command{
    .info = {.menu = "View",
             .label = "History",
             .keys = "Ctrl+H",
             .about = "The steps of undo by what was done in each; a click goes there."},
    .checked = [](const Designer& designer) { return designer.history; },
    .perform =
        [](Designer& designer, std::size_t) {
            designer.history = !designer.history;
            designer.panels |= designer.history;
        }};

}  // namespace nacre
