// Where the designer's files come from.
#pragma once

#include <optional>

#include "app/designer/designer.h"

namespace nacre {

// The desktop's file dialogs, where there are some and the settings want them.
std::optional<DialogProgram> file_dialogs(const Designer& designer);

}  // namespace nacre
