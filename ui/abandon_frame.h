// For a frame whose drawing was cut short.
#pragma once

namespace nacre::ui {

// Ends every window, group and list that is open, so that the frame can be finished as it is.
void abandon_frame();

}  // namespace nacre::ui
