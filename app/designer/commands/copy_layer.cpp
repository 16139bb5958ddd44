#include "app/designer/command.h"
#include "app/designer/layer_clipboard.h"

namespace nacre {

const Command copy_layer_command{.info = {.menu = "Edit",
                                          .label = "Copy",
                                          .keys = "Ctrl+C",
                                          .about = "A copy of the chosen layer goes to the clipboard."},
                                 .perform = [](Designer& designer, std::size_t) { copy_layer(designer); }};

}  // namespace nacre
