// What lies over a preview that shows two sides, or a factor: the divider, the names of the sides, the scale.
#pragma once

#include <imgui.h>

#include <functional>
#include <string>

namespace nacre::ui {

// A line down the area that can be dragged; `divider` is its part of the width. To be called before the
// widget that fills the area, which the line lies upon.
void divider_handle(double& divider, ImVec2 corner, ImVec2 size);
void draw_divider(double divider, ImVec2 corner, ImVec2 size);

// In the upper corners, but for an empty one; each is cut with an ellipsis at the middle of the area, so that
// they never meet.
void side_labels(const std::string& left, const std::string& right, ImVec2 corner, ImVec2 size);

// A bar of colours at the lower left with a number at either end.
struct ScaleLegend {
    std::string title, low, high;
    std::function<ImU32(float)> colour;  // of [0, 1]
};
void scale_legend(const ScaleLegend& legend, ImVec2 corner, ImVec2 size);

}  // namespace nacre::ui
