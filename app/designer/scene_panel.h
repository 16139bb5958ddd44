// Light, exposure and camera. Here and not in ui/, as the scene belongs to the preview and not to the
// design.
#pragma once

#include "app/preview/scene.h"

namespace nacre {

void scene_panel(Scene& scene);
void reset_camera(Scene& scene);

}  // namespace nacre
