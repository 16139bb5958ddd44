#include "app/desktop/key_latch.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>
#include <imgui_impl_glfw.h>

#include "app/desktop/window.h"
#include "ui/key_press.h"

namespace nacre {

KeyLatch::KeyLatch(GLFWwindow* window) : window_(window) {
    static_assert(keys == GLFW_KEY_LAST + 1);
    for (int key = 0; key < keys; ++key) on_layout_[static_cast<std::size_t>(key)] = key;
    glfwSetWindowUserPointer(window, this);
    glfwSetKeyCallback(window, [](GLFWwindow* from, int key, int code, int action, int modifiers) {
        Window::notice();
        if (key < 0 || key >= keys) return;
        auto* latch = static_cast<KeyLatch*>(glfwGetWindowUserPointer(from));
        ImGui_ImplGlfw_KeyCallback(from, latch->hear(key, action, modifiers), code, action, modifiers);
    });
    glfwSetDropCallback(window, [](GLFWwindow* from, int count, const char** files) {
        Window::notice();
        auto* latch = static_cast<KeyLatch*>(glfwGetWindowUserPointer(from));
        latch->dropped_.insert(latch->dropped_.end(), files, files + count);
    });
}

int KeyLatch::hear(int position, int action, int modifiers) {
    int& key = on_layout_[static_cast<std::size_t>(position)];
    if (action != GLFW_PRESS) return key;
    // Of a key of the number pad the name is a digit too.
    const bool prints = position <= GLFW_KEY_WORLD_2;
    key = prints ? ui::key_on_layout(position, glfwGetKeyName(position, 0)) : position;
    pressed_[static_cast<std::size_t>(key)] = true;
    if (key >= GLFW_KEY_LEFT_SHIFT && key <= GLFW_KEY_RIGHT_SUPER) return key;
    // AltGr is no modifier to GLFW; what it types is no shortcut.
    const bool graphic = glfwGetKey(window_, GLFW_KEY_RIGHT_ALT) == GLFW_PRESS;
    modifiers_ = graphic ? modifiers | GLFW_MOD_ALT : modifiers;
    any_pressed_ = true;
    return key;
}

KeyLatch::~KeyLatch() {
    glfwSetKeyCallback(window_, nullptr);
    glfwSetDropCallback(window_, nullptr);
    glfwSetWindowUserPointer(window_, nullptr);
}

void KeyLatch::press_missed() {
    ImGuiIO& io = ImGui::GetIO();
    for (std::size_t key = 0; key < pressed_.size(); ++key) {
        held_here_[key] = pressed_[key] && !io.KeysDown[key];
        io.KeysDown[key] |= held_here_[key];
    }
    pressed_ = {};
    if (!any_pressed_) return;
    io.KeyCtrl = (modifiers_ & GLFW_MOD_CONTROL) != 0;
    io.KeyShift = (modifiers_ & GLFW_MOD_SHIFT) != 0;
    io.KeyAlt = (modifiers_ & GLFW_MOD_ALT) != 0;
}

void KeyLatch::release_missed() {
    ImGuiIO& io = ImGui::GetIO();
    for (std::size_t key = 0; key < held_here_.size(); ++key)
        if (held_here_[key]) io.KeysDown[key] = false;
    held_here_ = {};
    any_pressed_ = false;
    io.KeyCtrl = io.KeysDown[GLFW_KEY_LEFT_CONTROL] || io.KeysDown[GLFW_KEY_RIGHT_CONTROL];
    io.KeyShift = io.KeysDown[GLFW_KEY_LEFT_SHIFT] || io.KeysDown[GLFW_KEY_RIGHT_SHIFT];
    io.KeyAlt = io.KeysDown[GLFW_KEY_LEFT_ALT] || io.KeysDown[GLFW_KEY_RIGHT_ALT];
}

}  // namespace nacre
