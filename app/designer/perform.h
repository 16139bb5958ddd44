// What the menus show of the designer, and what their commands do.
#pragma once

#include <optional>

#include "app/designer/designer.h"
#include "ui/commands.h"

namespace nacre {

ui::MenuState menu_state(const Designer& designer);

// The desktop's file dialogs, where there are some and the settings want them.
std::optional<DialogProgram> file_dialogs(const Designer& designer);

}  // namespace nacre
