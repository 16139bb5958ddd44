#include "app/designer/command.h"
#include "app/designer/other_side.h"

namespace nacre {

const Command show_other_command{
    .info = {.menu = "View",
             .label = "Other side",
             .keys = "A",
             .about = "The snapshot in place of the design, and back; held, for as long."},
    .checked = [](const Designer& designer) { return designer.comparison.shows_other(); },
    .perform = [](Designer& designer, std::size_t) { toggle_other_side(designer); }};

}  // namespace nacre
