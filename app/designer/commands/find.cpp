#include "app/designer/command.h"

namespace nacre {

const Command find_command{
    .info = {.menu = "Edit",
             .label = "Find",
             .keys = "Ctrl+K",
             .also = "F3",
             .about = "Find a command, tool, preset or setting by what it is called.",
             .begins_group = true},
    .perform = [](Designer& designer, std::size_t) { designer.search = ui::CommandSearch{}; }};

}  // namespace nacre
