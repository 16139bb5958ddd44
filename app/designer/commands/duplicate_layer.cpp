#include "app/designer/command.h"
#include "ui/layer_list.h"

namespace nacre {

const Command duplicate_layer_command{.info = {.menu = "Edit",
                                               .label = "Duplicate",
                                               .keys = "Ctrl+D",
                                               .about = "A copy of the chosen layer, after it."},
                                      .enabled =
                                          [](const Designer& designer) {
                                              return ui::possible(
                                                  ui::LayerAction::duplicate, designer.layers.chosen,
                                                  designer.document.design.distribution.layers.size());
                                          },
                                      .perform =
                                          [](Designer& designer, std::size_t) {
                                              ui::act(ui::LayerAction::duplicate, designer.layers,
                                                      designer.document.design.distribution.layers);
                                          }};

}  // namespace nacre
