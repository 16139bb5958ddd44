#include "app/designer/command.h"
#include "app/designer/layer_clipboard.h"

namespace nacre {

const Command paste_layer_command{.info = {.menu = "Edit",
                                           .label = "Paste",
                                           .keys = "Ctrl+V",
                                           .about = "The layers of the clipboard, after the chosen one."},
                                  .perform = [](Designer& designer, std::size_t) { paste_layer(designer); }};

}  // namespace nacre
