// What GLFW tells between two frames and Dear ImGui 1.86 has no ear for: files dropped on the window, the
// letters that the layout has on the keys, and keys that go down and up again, or outlive their modifiers,
// which it would miss where frames are slow.
#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

struct GLFWwindow;

namespace nacre {

class KeyLatch {
  public:
    // Listens to the window's keys in place of Dear ImGui's GLFW backend, to which it passes them on; to be
    // made after it.
    explicit KeyLatch(GLFWwindow* window);
    ~KeyLatch();
    KeyLatch(const KeyLatch&) = delete;
    KeyLatch& operator=(const KeyLatch&) = delete;

    // Before ImGui::NewFrame and after the frame: missed keys are down for this one frame.
    void press_missed();
    void release_missed();

    // Paths of the files dropped since the last call.
    std::vector<std::string> take_dropped() { return std::exchange(dropped_, {}); }

  private:
    static constexpr int keys = 349;  // GLFW_KEY_LAST + 1

    // Notes a key that goes down. Returns its number by the layout, as it was when the key went down.
    int hear(int position, int action, int modifiers);

    GLFWwindow* window_;
    std::array<int, keys> on_layout_{};  // the number that each position went down with
    std::array<bool, keys> pressed_{};   // since the last frame
    std::array<bool, keys> held_here_{};
    std::vector<std::string> dropped_;
    bool any_pressed_ = false;  // of those that are no modifiers
    int modifiers_ = 0;         // while the newest of them went down; may be up again by now
};

}  // namespace nacre
