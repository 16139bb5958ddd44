#include "app/designer/command.h"

namespace nacre {

const Command save_command{
    .info = {.menu = "File",
             .label = "Save",
             .keys = "Ctrl+S",
             .about = "Write the design to its file.",
             .begins_group = true},
    .perform = [](Designer& designer, std::size_t) { designer.files.save(designer.document); }};

}  // namespace nacre
