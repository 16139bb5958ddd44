// What GLFW tells between two frames: files dropped on the window, and keys by the letters that the layout
// has on them. Dear ImGui gets the keys once a frame, with those that went down and up again or outlived
// their modifiers, which it would miss where frames are slow.
#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

struct GLFWwindow;

namespace nacre {

class KeyLatch {
  public:
    // Listens to the window's keys in place of Dear ImGui's GLFW backend; to be made after it.
    explicit KeyLatch(GLFWwindow* window);
    ~KeyLatch();
    KeyLatch(const KeyLatch&) = delete;
    KeyLatch& operator=(const KeyLatch&) = delete;

    // Before ImGui::NewFrame: keys that went down since the last call are down for this frame at least.
    void tell();

    // Paths of the files dropped since the last call.
    std::vector<std::string> take_dropped() { return std::exchange(dropped_, {}); }

  private:
    static constexpr int keys = 349;  // GLFW_KEY_LAST + 1

    // A key comes up under the number that it went down with.
    void hear(int position, int action, int modifiers);

    GLFWwindow* window_;
    std::array<int, keys> on_layout_{};  // the number that each position went down with
    std::array<bool, keys> down_{};
    std::array<bool, keys> pressed_{};  // since the last frame
    std::vector<std::string> dropped_;
    bool any_pressed_ = false;  // of those that are no modifiers
    int modifiers_ = 0;         // while the newest of them went down; may be up again by now
};

}  // namespace nacre
