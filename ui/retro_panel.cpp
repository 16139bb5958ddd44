#include "ui/kind_fields.h"
#include "ui/material_panel.h"

namespace nacre::ui {

bool retro_panel(Retro& retro) { return part_fields(retro); }

}  // namespace nacre::ui
