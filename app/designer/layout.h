// Where the parts of the window stand: a panel at the left, the canvas beside it, the preview at the right,
// menu above, status below, a drawer below canvas and preview and a history below the panel that can be open.
// The borders between them can be dragged, but for that of the history.
#pragma once

#include <functional>
#include <optional>

namespace nacre {

inline constexpr float panel_min = 20, panel_max = 40;         // text sizes
inline constexpr float canvas_min = 0.25f, canvas_max = 0.8f;  // of the width beside the panel
inline constexpr float drawer_min = 14;                        // text sizes

// Where the borders stand, for windows and scales of any size: all that is worth keeping between runs.
struct Layout {
    float panel = 21.5f;   // width in text sizes
    float canvas = 0.44f;  // part of the width beside the panel: the object is the largest thing
    float drawer = 17.5f;  // height in text sizes; no more of it is shown than the window has room for
    bool operator==(const Layout&) const = default;
};

// Left, top and size of a part; pixels.
struct PartBox {
    float left, top, width, height;
};

struct Shown {
    bool panel, drawer;
    bool history = false;  // with the panel
};

// Of this frame.
struct Places {
    std::optional<PartBox> panel, drawer, history;  // where they are shown
    PartBox canvas, preview, status;
};
Places place_parts(const Layout& layout, const Shown& shown);

// Each part is a Dear ImGui window of its own. First the input of this frame does its work in all of them,
// ...
struct InputParts {
    std::function<void()> panel, canvas, preview, history = {};
};
void take_input(const Places& places, const InputParts& parts);

// ... then what came of it is drawn. Only a dragged border changes `layout`: a window too small for it shows
// what fits and gives it back when it grows.
struct DrawnParts {
    std::function<void()> canvas, preview, drawer, status;
};
void draw_parts(Layout& layout, const Places& places, const DrawnParts& parts);

}  // namespace nacre
