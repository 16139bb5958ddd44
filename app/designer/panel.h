// The panel at the left: layers, material, light, comparison, presets.
#pragma once

namespace nacre {

struct Designer;

void draw_panel(Designer& designer);

}  // namespace nacre
