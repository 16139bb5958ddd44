// Calls the design "Renamed".
#include "app/designer/command.h"

namespace nacre {

const Command rename_command{
    .info = {.menu = "Edit", .label = "Rename", .keys = "F8", .about = "Call the design Renamed."},
    .enabled = [](const Designer& designer) { return designer.document.design.name != "Renamed"; },
    .perform = [](Designer& designer, std::size_t) { designer.document.design.name = "Renamed"; }};

}  // namespace nacre
