// The keyboard's pointer: what needs a pointer, as the canvas and the preview do, can be worked without a
// mouse.
#pragma once

#include <imgui.h>

#include <optional>

struct ImGuiWindow;

namespace nacre::ui {

// Arrows move it, with Shift by one pixel; Enter clicks, Space presses the left button and lets it go again,
// Page Up and Page Down turn the wheel. It ends by Escape, F6, F10, by a menu or dialog, or when the mouse
// moves.
class FocusPointer {
  public:
    // Into the middle of what lies between these corners; pixels.
    void enter(ImGuiWindow* window, ImVec2 low, ImVec2 high);
    void leave();
    bool active() const { return at_.has_value(); }

    // Before ImGui::NewFrame: in place of the mouse.
    void tell(ImGuiIO& io);

    // After it: takes its keys. What it stands in has these corners now.
    void work();
    void follow(ImGuiWindow* window, ImVec2 low, ImVec2 high);

    void draw() const;

  private:
    void take_arrows();

    std::optional<ImVec2> at_;
    std::optional<ImVec2> mouse_;  // where it was, for whether it has moved since
    ImVec2 told_{0, 0};            // where this one was in the frame before
    ImVec2 low_{0, 0}, high_{0, 0};
    ImGuiWindow* window_ = nullptr;
    bool holds_ = false, clicks_ = false;  // clicks_: the button is to be let go in the next frame
    float wheel_ = 0;
};

}  // namespace nacre::ui
