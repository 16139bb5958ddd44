#include "ui/abandon_frame.h"

#include <imgui.h>
#include <imgui_internal.h>

namespace nacre::ui {

void abandon_frame() { ImGui::ErrorCheckEndFrameRecover(nullptr); }

}  // namespace nacre::ui
