#include "app/headless/input.h"

#include <utility>

namespace nacre {
namespace {

constexpr std::pair<const char*, ImGuiKey> named_keys[] = {
    {"Escape", ImGuiKey_Escape},    {"Enter", ImGuiKey_Enter},
    {"Tab", ImGuiKey_Tab},          {"Backspace", ImGuiKey_Backspace},
    {"Insert", ImGuiKey_Insert},    {"Delete", ImGuiKey_Delete},
    {"Right", ImGuiKey_RightArrow}, {"Left", ImGuiKey_LeftArrow},
    {"Down", ImGuiKey_DownArrow},   {"Up", ImGuiKey_UpArrow},
    {"PageUp", ImGuiKey_PageUp},    {"PageDown", ImGuiKey_PageDown},
    {"Home", ImGuiKey_Home},        {"End", ImGuiKey_End},
    {"Space", ImGuiKey_Space},      {"KeypadEnter", ImGuiKey_KeyPadEnter},
};

constexpr std::pair<ImGuiKey, int> letters[] = {{ImGuiKey_A, 'A'}, {ImGuiKey_C, 'C'}, {ImGuiKey_V, 'V'},
                                                {ImGuiKey_X, 'X'}, {ImGuiKey_Y, 'Y'}, {ImGuiKey_Z, 'Z'}};

constexpr int left_shift = 340;
constexpr int left_control = 341;
constexpr int left_alt = 342;

// What the key types on a US keyboard; Shift makes letters of letters, other signs have keys of their own
// here.
void type(ImGuiIO& io, const ui::KeyPress& press) {
    const bool letter = press.key >= 'A' && press.key <= 'Z', prints = press.key >= ' ' && press.key <= '~';
    if (!prints || press.ctrl || press.alt || (press.shift && !letter)) return;
    io.AddInputCharacter(static_cast<unsigned>(letter && !press.shift ? press.key - 'A' + 'a' : press.key));
}

}  // namespace

void map_keys(ImGuiIO& io) {
    for (const auto& [name, meaning] : named_keys) io.KeyMap[meaning] = ui::parse_key(name)->key;
    for (const auto& [meaning, key] : letters) io.KeyMap[meaning] = key;
}

void set_key(ImGuiIO& io, const ui::KeyPress& press, bool down) {
    io.KeysDown[press.key] = down;
    io.KeysDown[left_control] = io.KeyCtrl = down && press.ctrl;
    io.KeysDown[left_shift] = io.KeyShift = down && press.shift;
    io.KeysDown[left_alt] = io.KeyAlt = down && press.alt;
    if (down) type(io, press);
}

}  // namespace nacre
