#include "app/designer/command.h"
#include "app/designer/scene_panel.h"

namespace nacre {

const Command reset_camera_command{
    .info = {.menu = "View",
             .label = "Reset camera",
             .keys = nullptr,
             .about = "Back to the first view.",
             .begins_group = true},
    .perform = [](Designer& designer, std::size_t) { reset_camera(designer.scene); }};

}  // namespace nacre
