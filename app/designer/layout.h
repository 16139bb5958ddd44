// Where the parts of the window stand: a panel at the left, the canvas beside it, the preview at the right,
// menu above, status below. The borders between them can be dragged.
#pragma once

#include <functional>

namespace nacre {

struct Layout {
    float panel = 0;   // breadth, pixels; 0 until the first frame
    float canvas = 0;  // part of the breadth beside the panel
    bool operator==(const Layout&) const = default;
};

struct Parts {
    std::function<void()> panel;  // empty: hidden
    std::function<void()> canvas;
    std::function<void()> preview;
    std::function<void()> status;
};

// Draws each part in a Dear ImGui window of its own.
void draw_layout(Layout& layout, const Parts& parts);

}  // namespace nacre
