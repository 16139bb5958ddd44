#include "app/designer/command.h"

namespace nacre {

const Command new_design_command{
    .info = {.menu = "File", .label = "New", .keys = "Ctrl+N", .about = "A new design, red lacquer."},
    .perform = [](Designer& designer, std::size_t) { designer.files.start_new(designer.document); }};

}  // namespace nacre
