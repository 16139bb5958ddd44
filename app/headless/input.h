// Input of Dear ImGui without a window.
#pragma once

#include <imgui.h>

#include "ui/key_press.h"

namespace nacre {

void set_key(ImGuiIO& io, const ui::KeyPress& press, bool down);

}  // namespace nacre
