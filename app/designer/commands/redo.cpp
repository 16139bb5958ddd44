#include "app/designer/command.h"

namespace nacre {

const Command redo_command{
    .info = {.menu = "Edit",
             .label = "Redo",
             .keys = "Ctrl+Shift+Z",
             .also = "Ctrl+Y",
             .about = "Do again what was taken back.",
             .repeats = true},
    .enabled = [](const Designer& designer) { return designer.document.history.can_redo(); },
    .perform = [](Designer& designer, std::size_t) { designer.document.redo(); }};

}  // namespace nacre
