// The GLFW window and its OpenGL 3.3 core context.
#pragma once

#include <glm/vec2.hpp>
#include <string>

struct GLFWwindow;

namespace nacre {

class Window {
  public:
    // Throws std::runtime_error without a display or without OpenGL 3.3. `size` is in the monitor's own
    // units, before its scale.
    Window(glm::ivec2 size, const std::string& title);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    GLFWwindow* handle() const { return window_; }
    // How much larger than usual the monitor wants text, in the window's units, ...
    float monitor_scale() const;
    // ... which are several pixels each on some systems.
    float pixels_a_unit() const;
    glm::ivec2 framebuffer_size() const;

    void set_title(const std::string& title);
    // Over the whole monitor that most of the window is on, or back to where it was.
    void set_full_screen(bool wanted);
    // The close button since the last call.
    bool take_close_request();
    // Whether it has got the focus since the last call.
    bool take_focus();
    void swap();

    // Waits for events. Returns whether one came since the last wait that may change what is shown: told by
    // the events, since how long the wait took says nothing about one at its very end.
    bool wait(double seconds);
    // To be called for such an event that this class does not see, ...
    static void notice();
    // ... or from any thread to end the wait.
    static void wake();

  private:
    GLFWwindow* window_ = nullptr;
    std::string title_;
    bool full_screen_ = false;
    bool focused_ = true;
    glm::ivec2 place_{0}, size_{0};  // before full screen
};

}  // namespace nacre
