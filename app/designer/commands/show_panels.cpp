#include "app/designer/command.h"

namespace nacre {

const Command show_panels_command{
    .info = {.menu = "View",
             .label = "Panels",
             .keys = "Tab",
             .about = "Hide the panels and show them again."},
    .checked = [](const Designer& designer) { return designer.panels; },
    .perform = [](Designer& designer, std::size_t) { designer.panels = !designer.panels; }};

}  // namespace nacre
