#include "app/designer/command.h"

namespace nacre {

const Command save_as_command{
    .info = {.menu = "File",
             .label = "Save as\u2026",
             .keys = "Ctrl+Shift+S",
             .about = "Write the design to another file and go on there."},
    .perform = [](Designer& designer, std::size_t) { designer.files.save_as(designer.document); }};

}  // namespace nacre
