// How a tool of the canvas is shown.
#pragma once

#include "core/paint/icon_pen.h"

namespace nacre {

struct ToolFace {
    const char* name;
    char key;           // a letter
    const char* about;  // one line for tooltip, sheet and manual
    const char* more;   // for the tooltip alone
    void (*icon)(const IconPen& pen);
    bool begins_group = false;  // a gap before its button
};

}  // namespace nacre
