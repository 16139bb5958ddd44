#include "app/designer/command.h"

namespace nacre {

const Command choose_layer_command{.info = {.menu = "Canvas",
                                            .label = nullptr,
                                            .keys = ui::nine_digits,
                                            .about = "Choose the layer of this number."},
                                   .perform = [](Designer& designer, std::size_t which) {
                                       if (which < designer.document.design.distribution.layers.size())
                                           designer.layers.chosen = which;
                                   }};

}  // namespace nacre
