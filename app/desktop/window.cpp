#include "app/desktop/window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <atomic>
#include <stdexcept>
#include <utility>

#include "core/base/error.h"

namespace nacre {
namespace {

std::atomic<bool> noticed{true};  // since the last wait; the first frame is there to be drawn

// Of whatever may change what the window shows. Those that Dear ImGui's backend takes for itself go on to
// these.
void notice_all(GLFWwindow* window) {
    glfwSetFramebufferSizeCallback(window, [](GLFWwindow*, int, int) { Window::notice(); });
    glfwSetWindowSizeCallback(window, [](GLFWwindow*, int, int) { Window::notice(); });
    glfwSetWindowRefreshCallback(window, [](GLFWwindow*) { Window::notice(); });
    glfwSetWindowPosCallback(window, [](GLFWwindow*, int, int) { Window::notice(); });
    glfwSetWindowContentScaleCallback(window, [](GLFWwindow*, float, float) { Window::notice(); });
    glfwSetWindowIconifyCallback(window, [](GLFWwindow*, int) { Window::notice(); });
    glfwSetWindowMaximizeCallback(window, [](GLFWwindow*, int) { Window::notice(); });
    glfwSetWindowCloseCallback(window, [](GLFWwindow*) { Window::notice(); });
    glfwSetWindowFocusCallback(window, [](GLFWwindow*, int) { Window::notice(); });
    glfwSetCursorEnterCallback(window, [](GLFWwindow*, int) { Window::notice(); });
    glfwSetCursorPosCallback(window, [](GLFWwindow*, double, double) { Window::notice(); });
    glfwSetMouseButtonCallback(window, [](GLFWwindow*, int, int, int) { Window::notice(); });
    glfwSetScrollCallback(window, [](GLFWwindow*, double, double) { Window::notice(); });
    glfwSetCharCallback(window, [](GLFWwindow*, unsigned) { Window::notice(); });
}

std::runtime_error glfw_failure(const char* what) {
    const char* reason = nullptr;
    glfwGetError(&reason);
    return std::runtime_error(std::string(what) +
                              (reason != nullptr ? std::string(" (") + reason + ")" : ""));
}

// Null without any monitor.
GLFWmonitor* monitor_under(glm::ivec2 point) {
    int count = 0;
    GLFWmonitor** monitors = glfwGetMonitors(&count);
    for (int i = 0; i < count; ++i) {
        glm::ivec2 low{0}, size{0};
        glfwGetMonitorPos(monitors[i], &low.x, &low.y);
        if (const GLFWvidmode* mode = glfwGetVideoMode(monitors[i])) size = {mode->width, mode->height};
        const glm::ivec2 inside = point - low;
        if (inside.x >= 0 && inside.y >= 0 && inside.x < size.x && inside.y < size.y) return monitors[i];
    }
    return glfwGetPrimaryMonitor();
}

}  // namespace

Window::Window(glm::ivec2 size, const std::string& title) : title_(title) {
    if (glfwInit() != GLFW_TRUE) throw glfw_failure("no window: the display cannot be opened");
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
    glfwWindowHint(GLFW_DEPTH_BITS, 0);
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
    glfwWindowHintString(GLFW_X11_CLASS_NAME, "nacre");
    window_ = glfwCreateWindow(size.x, size.y, title.c_str(), nullptr, nullptr);
    if (window_ == nullptr) {
        const std::runtime_error failure = glfw_failure("no window: OpenGL 3.3 core is not available");
        glfwTerminate();
        throw failure;
    }
    glfwMakeContextCurrent(window_);
    glfwSwapInterval(1);
    notice_all(window_);
}

Window::~Window() {
    glfwDestroyWindow(window_);
    glfwTerminate();
}

float Window::monitor_scale() const {
    float x = 1;
    float y = 1;
    glfwGetWindowContentScale(window_, &x, &y);
    return x > 0 ? x / pixels_a_unit() : 1;
}

float Window::pixels_a_unit() const {
    glm::ivec2 units{0};
    glfwGetWindowSize(window_, &units.x, &units.y);
    const glm::ivec2 pixels = framebuffer_size();
    return units.x > 0 && pixels.x > 0 ? static_cast<float>(pixels.x) / static_cast<float>(units.x) : 1;
}

glm::ivec2 Window::framebuffer_size() const {
    glm::ivec2 size{0};
    glfwGetFramebufferSize(window_, &size.x, &size.y);
    return size;
}

void Window::set_title(const std::string& title) {
    if (title == title_) return;
    title_ = title;
    glfwSetWindowTitle(window_, one_line(title).c_str());  // a file's name may be no UTF-8
}

void Window::set_full_screen(bool wanted) {
    if (wanted == full_screen_) return;
    full_screen_ = wanted;
    if (!wanted) {
        glfwSetWindowMonitor(window_, nullptr, place_.x, place_.y, size_.x, size_.y, GLFW_DONT_CARE);
        return;
    }
    glfwGetWindowPos(window_, &place_.x, &place_.y);
    glfwGetWindowSize(window_, &size_.x, &size_.y);
    GLFWmonitor* monitor = monitor_under(place_ + size_ / 2);
    if (monitor == nullptr) return;
    const GLFWvidmode* mode = glfwGetVideoMode(monitor);
    glfwSetWindowMonitor(window_, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
}

bool Window::take_close_request() {
    if (glfwWindowShouldClose(window_) == GLFW_FALSE) return false;
    glfwSetWindowShouldClose(window_, GLFW_FALSE);
    return true;
}

bool Window::take_focus() {
    const bool before = std::exchange(focused_, glfwGetWindowAttrib(window_, GLFW_FOCUSED) == GLFW_TRUE);
    return focused_ && !before;
}

void Window::swap() { glfwSwapBuffers(window_); }

bool Window::wait(double seconds) {
    glfwWaitEventsTimeout(seconds);
    return noticed.exchange(false);
}

void Window::notice() { noticed = true; }

void Window::wake() {
    notice();
    glfwPostEmptyEvent();
}

}  // namespace nacre
