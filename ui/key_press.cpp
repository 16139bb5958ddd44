#include "ui/key_press.h"

#include <imgui.h>

#include <cctype>

#include "ui/keys.h"

namespace nacre::ui {
namespace {

std::optional<int> key_number(std::string_view name) {
    if (const auto named = named_key(name)) return named;
    if (name.size() != 1 || std::isspace(static_cast<unsigned char>(name[0])) != 0) return std::nullopt;
    return std::toupper(static_cast<unsigned char>(name[0]));
}

}  // namespace

int key_on_layout(int position, const char* name) {
    if (name == nullptr || name[0] == 0 || name[1] != 0) return position;
    const auto sign = static_cast<unsigned char>(name[0]);
    if (std::isalnum(sign) != 0) return std::toupper(sign);
    const bool digit = position >= '0' && position <= '9';
    return std::isgraph(sign) != 0 && !digit ? sign : position;
}

std::optional<KeyPress> parse_key(std::string_view text) {
    KeyPress press;
    for (auto plus = text.find('+'); plus != std::string_view::npos && plus + 1 < text.size();
         plus = text.find('+')) {
        const std::string_view modifier = text.substr(0, plus);
        if (modifier == "Ctrl")
            press.ctrl = true;
        else if (modifier == "Shift")
            press.shift = true;
        else if (modifier == "Alt")
            press.alt = true;
        else
            return std::nullopt;
        text.remove_prefix(plus + 1);
    }
    const auto key = key_number(text);
    if (!key) return std::nullopt;
    press.key = *key;
    return press;
}

bool is_pressed(const KeyPress& press, bool repeat) {
    const ImGuiIO& io = ImGui::GetIO();
    return press.ctrl == io.KeyCtrl && press.shift == io.KeyShift && press.alt == io.KeyAlt &&
           is_key_pressed(press.key, repeat);
}

bool is_typed(char sign) {
    const auto& typed = ImGui::GetIO().InputQueueCharacters;
    return typed.contains(static_cast<ImWchar>(sign));
}

}  // namespace nacre::ui
