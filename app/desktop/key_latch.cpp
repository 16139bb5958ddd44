#include "app/desktop/key_latch.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include "app/desktop/window.h"
#include "ui/key_press.h"
#include "ui/keys.h"

namespace nacre {

KeyLatch::KeyLatch(GLFWwindow* window) : window_(window) {
    static_assert(keys == GLFW_KEY_LAST + 1);
    for (int key = 0; key < keys; ++key) on_layout_[static_cast<std::size_t>(key)] = key;
    glfwSetWindowUserPointer(window, this);
    ui::map_keys(ImGui::GetIO());
    glfwSetKeyCallback(window, [](GLFWwindow* from, int key, int, int action, int modifiers) {
        Window::notice();
        if (key < 0 || key >= keys) return;
        static_cast<KeyLatch*>(glfwGetWindowUserPointer(from))->hear(key, action, modifiers);
    });
    glfwSetDropCallback(window, [](GLFWwindow* from, int count, const char** files) {
        Window::notice();
        auto* latch = static_cast<KeyLatch*>(glfwGetWindowUserPointer(from));
        latch->dropped_.insert(latch->dropped_.end(), files, files + count);
    });
}

void KeyLatch::hear(int position, int action, int modifiers) {
    int& key = on_layout_[static_cast<std::size_t>(position)];
    if (action == GLFW_RELEASE) down_[static_cast<std::size_t>(key)] = false;
    if (action != GLFW_PRESS) return;
    // Of a key of the number pad the name is a digit too.
    const bool prints = position <= GLFW_KEY_WORLD_2;
    key = prints ? ui::key_on_layout(position, glfwGetKeyName(position, 0)) : position;
    pressed_[static_cast<std::size_t>(key)] = down_[static_cast<std::size_t>(key)] = true;
    if (key >= GLFW_KEY_LEFT_SHIFT && key <= GLFW_KEY_RIGHT_SUPER) return;
    // AltGr is no modifier to GLFW; what it types is no shortcut.
    const bool graphic = glfwGetKey(window_, GLFW_KEY_RIGHT_ALT) == GLFW_PRESS;
    modifiers_ = graphic ? modifiers | GLFW_MOD_ALT : modifiers;
    any_pressed_ = true;
}

KeyLatch::~KeyLatch() {
    glfwSetKeyCallback(window_, nullptr);
    glfwSetDropCallback(window_, nullptr);
    glfwSetWindowUserPointer(window_, nullptr);
}

void KeyLatch::tell() {
    ImGuiIO& io = ImGui::GetIO();
    for (std::size_t key = 0; key < down_.size(); ++key)
        ui::tell_key(io, static_cast<int>(key), down_[key] || pressed_[key]);
    pressed_ = {};
    const auto held = [&](int left, int right) {
        return down_[static_cast<std::size_t>(left)] || down_[static_cast<std::size_t>(right)];
    };
    if (std::exchange(any_pressed_, false))
        ui::tell_modifiers(io, (modifiers_ & GLFW_MOD_CONTROL) != 0, (modifiers_ & GLFW_MOD_SHIFT) != 0,
                           (modifiers_ & GLFW_MOD_ALT) != 0);
    else
        ui::tell_modifiers(io, held(GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL),
                           held(GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT),
                           held(GLFW_KEY_LEFT_ALT, GLFW_KEY_RIGHT_ALT));
}

}  // namespace nacre
