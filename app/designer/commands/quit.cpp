#include "app/designer/command.h"

namespace nacre {

const Command quit_command{
    .info = {.menu = "File",
             .label = "Quit",
             .keys = "Ctrl+Q",
             .about = "Asks first where work is unsaved.",
             .begins_group = true},
    .perform = [](Designer& designer, std::size_t) { designer.files.quit(designer.document); }};

}  // namespace nacre
