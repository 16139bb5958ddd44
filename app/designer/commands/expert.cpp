#include "app/designer/command.h"

namespace nacre {

const Command expert_command{
    .info = {.menu = "View",
             .label = "Expert",
             .keys = "Ctrl+Shift+X",
             .about =
                 "All numbers of layers, factors of the BRDF and tables, or only what an artist calls them."},
    .checked = [](const Designer& designer) { return designer.layers.expert; },
    .perform = [](Designer& designer, std::size_t) { designer.layers.expert = !designer.layers.expert; }};

}  // namespace nacre
