#include "app/designer/command.h"

namespace nacre {

const Command open_command{
    .info = {.menu = "File",
             .label = "Open\u2026",
             .keys = "Ctrl+O",
             .about = "Open a design from a .nacre file."},
    .perform = [](Designer& designer, std::size_t) { designer.files.start_open(designer.document); }};

}  // namespace nacre
