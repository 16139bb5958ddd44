// Keys that go down and up again between two frames, or outlive their modifiers. Dear ImGui 1.86 looks only
// at what is down when a frame begins and would miss them where frames are slow.
#pragma once

#include <array>

struct GLFWwindow;

namespace nacre {

class KeyLatch {
  public:
    // Listens to the window's keys; to be made before Dear ImGui's GLFW backend, which passes them on.
    explicit KeyLatch(GLFWwindow* window);
    ~KeyLatch();
    KeyLatch(const KeyLatch&) = delete;
    KeyLatch& operator=(const KeyLatch&) = delete;

    // Before ImGui::NewFrame and after the frame: missed keys are down for this one frame.
    void press_missed();
    void release_missed();

  private:
    static constexpr int keys = 349;  // GLFW_KEY_LAST + 1

    GLFWwindow* window_;
    std::array<bool, keys> pressed_{};  // since the last frame
    std::array<bool, keys> held_here_{};
    bool any_pressed_ = false;  // of those that are no modifiers
    int modifiers_ = 0;         // while the newest of them went down; may be up again by now
};

}  // namespace nacre
