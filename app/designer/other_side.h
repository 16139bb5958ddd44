// The other side of a comparison in place of the design, by one key: a tap changes to it and back, a held key
// shows it for as long.
#pragma once

#include "app/designer/designer.h"

namespace nacre {

void toggle_other_side(Designer& designer);

// Once a frame: lets go with the key, where that was held for longer than a tap.
void follow_held_key(Designer& designer);

}  // namespace nacre
