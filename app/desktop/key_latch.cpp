#include "app/desktop/key_latch.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

namespace nacre {

KeyLatch::KeyLatch(GLFWwindow* window) : window_(window) {
    static_assert(keys == GLFW_KEY_LAST + 1);
    glfwSetWindowUserPointer(window, this);
    glfwSetKeyCallback(window, [](GLFWwindow* from, int key, int, int action, int modifiers) {
        auto* latch = static_cast<KeyLatch*>(glfwGetWindowUserPointer(from));
        if (action != GLFW_PRESS || key < 0 || key >= keys) return;
        // The letter that the layout has there, as Dear ImGui's backend numbers keys.
        const char* name = glfwGetKeyName(key, 0);
        if (name != nullptr && name[0] >= 'a' && name[0] <= 'z' && name[1] == 0) key = name[0] - 'a' + 'A';
        latch->pressed_[static_cast<std::size_t>(key)] = true;
        if (key >= GLFW_KEY_LEFT_SHIFT && key <= GLFW_KEY_RIGHT_SUPER) return;
        latch->modifiers_ = modifiers;
        latch->any_pressed_ = true;
    });
    glfwSetDropCallback(window, [](GLFWwindow* from, int count, const char** files) {
        auto* latch = static_cast<KeyLatch*>(glfwGetWindowUserPointer(from));
        latch->dropped_.insert(latch->dropped_.end(), files, files + count);
    });
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
