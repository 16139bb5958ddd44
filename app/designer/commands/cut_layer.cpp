#include "app/designer/command.h"
#include "app/designer/layer_clipboard.h"

namespace nacre {

const Command cut_layer_command{.info = {.menu = "Edit",
                                         .label = "Cut",
                                         .keys = "Ctrl+X",
                                         .about = "The chosen layer goes to the clipboard.",
                                         .begins_group = true},
                                .perform = [](Designer& designer, std::size_t) { cut_layer(designer); }};

}  // namespace nacre
