#include "app/designer/command.h"

namespace nacre {

const Command clear_recent_command{
    .info = {.menu = "File/Open recent",
             .label = "Clear the list",
             .keys = nullptr,
             .about = "Forget the designs used last.",
             .begins_group = true},
    .enabled = [](const Designer& designer) { return !designer.recent.files().empty(); },
    .perform = [](Designer& designer, std::size_t) { designer.recent.clear(); }};

}  // namespace nacre
