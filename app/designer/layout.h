// Where the parts of the window stand: a panel at the left, the canvas beside it, the preview at the right,
// menu above, status below, and a drawer below canvas and preview that can be open. The borders between them
// can be dragged.
#pragma once

#include <functional>

namespace nacre {

inline constexpr float panel_min = 20, panel_max = 40;         // text sizes
inline constexpr float canvas_min = 0.25f, canvas_max = 0.8f;  // of the width beside the panel
inline constexpr float drawer_min = 14;                        // text sizes

// Where the borders stand, for windows and scales of any size: all that is worth keeping between runs.
struct Layout {
    float panel = 21.5f;   // width in text sizes
    float canvas = 0.5f;   // part of the width beside the panel
    float drawer = 17.5f;  // height in text sizes; no more of it is shown than the window has room for
    bool operator==(const Layout&) const = default;
};

struct Parts {
    std::function<void()> panel;  // empty: hidden
    std::function<void()> canvas;
    std::function<void()> preview;
    std::function<void()> status;
    std::function<void()> drawer = {};  // empty: closed
};

// Draws each part in a Dear ImGui window of its own. Only a dragged border changes `layout`: a window too
// small for it shows what fits and gives it back when it grows.
void draw_layout(Layout& layout, const Parts& parts);

}  // namespace nacre
