#include "app/headless/input.h"

#include <cctype>
#include <string>
#include <utility>

namespace nacre {
namespace {

struct NamedKey {
    std::string_view name;
    int key;
    ImGuiKey meaning;  // ImGuiKey_COUNT: none of Dear ImGui's own
};

constexpr NamedKey named_keys[] = {
    {"Escape", 256, ImGuiKey_Escape},    {"Enter", 257, ImGuiKey_Enter},
    {"Tab", 258, ImGuiKey_Tab},          {"Backspace", 259, ImGuiKey_Backspace},
    {"Insert", 260, ImGuiKey_Insert},    {"Delete", 261, ImGuiKey_Delete},
    {"Right", 262, ImGuiKey_RightArrow}, {"Left", 263, ImGuiKey_LeftArrow},
    {"Down", 264, ImGuiKey_DownArrow},   {"Up", 265, ImGuiKey_UpArrow},
    {"PageUp", 266, ImGuiKey_PageUp},    {"PageDown", 267, ImGuiKey_PageDown},
    {"Home", 268, ImGuiKey_Home},        {"End", 269, ImGuiKey_End},
    {"Space", 32, ImGuiKey_Space},       {"KeypadEnter", 335, ImGuiKey_KeyPadEnter},
    {"F1", 290, ImGuiKey_COUNT},         {"F2", 291, ImGuiKey_COUNT},
    {"F11", 300, ImGuiKey_COUNT},        {"F12", 301, ImGuiKey_COUNT},
};

constexpr std::pair<ImGuiKey, int> letters[] = {{ImGuiKey_A, 'A'}, {ImGuiKey_C, 'C'}, {ImGuiKey_V, 'V'},
                                                {ImGuiKey_X, 'X'}, {ImGuiKey_Y, 'Y'}, {ImGuiKey_Z, 'Z'}};

constexpr int left_shift = 340;
constexpr int left_control = 341;
constexpr int left_alt = 342;

std::optional<int> key_number(std::string_view name) {
    for (const NamedKey& named : named_keys)
        if (named.name == name) return named.key;
    if (name.size() != 1 || std::isspace(static_cast<unsigned char>(name[0])) != 0) return std::nullopt;
    return std::toupper(static_cast<unsigned char>(name[0]));
}

}  // namespace

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

void map_keys(ImGuiIO& io) {
    for (const NamedKey& named : named_keys)
        if (named.meaning != ImGuiKey_COUNT) io.KeyMap[named.meaning] = named.key;
    for (const auto& [meaning, key] : letters) io.KeyMap[meaning] = key;
}

void set_key(ImGuiIO& io, const KeyPress& press, bool down) {
    io.KeysDown[press.key] = down;
    io.KeysDown[left_control] = io.KeyCtrl = down && press.ctrl;
    io.KeysDown[left_shift] = io.KeyShift = down && press.shift;
    io.KeysDown[left_alt] = io.KeyAlt = down && press.alt;
}

}  // namespace nacre
