// Where the parts of the window stand: a panel at each side that can be made broader, the picture
// between them, menu above, status below.
#pragma once

#include <functional>

namespace nacre {

struct Layout {
    float left = 0;  // breadths, pixels; 0 until the first frame
    float right = 0;
};

struct Parts {
    std::function<void()> left;
    std::function<void()> centre;
    std::function<void()> right;
    std::function<void()> status;
};

// Draws each part in a Dear ImGui window of its own.
void draw_layout(Layout& layout, const Parts& parts);

}  // namespace nacre
