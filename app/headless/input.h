// Input of Dear ImGui 1.86 without a window. Keys have GLFW's numbers, as the desktop's backend gives them.
#pragma once

#include <imgui.h>

#include "ui/key_press.h"

namespace nacre {

void map_keys(ImGuiIO& io);
void set_key(ImGuiIO& io, const ui::KeyPress& press, bool down);

}  // namespace nacre
