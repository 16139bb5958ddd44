#include "ui/keys.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>

// Since 1.87 every key has a name. Older versions name those that mean something to them, and know the others
// by the host's number alone.
#define NACRE_KEYS_HAVE_NAMES (IMGUI_VERSION_NUM >= 18700)

namespace nacre::ui {
namespace {

#if !NACRE_KEYS_HAVE_NAMES
constexpr ImGuiKey ImGuiKey_None = -1, ImGuiKey_KeypadEnter = ImGuiKey_KeyPadEnter;
constexpr ImGuiKey ImGuiKey_F1 = ImGuiKey_None, ImGuiKey_F2 = ImGuiKey_None, ImGuiKey_F3 = ImGuiKey_None,
                   ImGuiKey_F4 = ImGuiKey_None, ImGuiKey_F5 = ImGuiKey_None, ImGuiKey_F6 = ImGuiKey_None,
                   ImGuiKey_F7 = ImGuiKey_None, ImGuiKey_F8 = ImGuiKey_None, ImGuiKey_F9 = ImGuiKey_None,
                   ImGuiKey_F10 = ImGuiKey_None, ImGuiKey_F11 = ImGuiKey_None, ImGuiKey_F12 = ImGuiKey_None,
                   ImGuiKey_Menu = ImGuiKey_None;
#endif

struct NamedKey {
    std::string_view name;
    int number;
    ImGuiKey meaning;
};

constexpr NamedKey named_keys[] = {
    {"Escape", key::escape, ImGuiKey_Escape},
    {"Enter", key::enter, ImGuiKey_Enter},
    {"Tab", key::tab, ImGuiKey_Tab},
    {"Backspace", 259, ImGuiKey_Backspace},
    {"Insert", 260, ImGuiKey_Insert},
    {"Delete", key::remove, ImGuiKey_Delete},
    {"Right", key::right, ImGuiKey_RightArrow},
    {"Left", key::left, ImGuiKey_LeftArrow},
    {"Down", key::down, ImGuiKey_DownArrow},
    {"Up", key::up, ImGuiKey_UpArrow},
    {"PageUp", key::page_up, ImGuiKey_PageUp},
    {"PageDown", key::page_down, ImGuiKey_PageDown},
    {"Home", 268, ImGuiKey_Home},
    {"End", 269, ImGuiKey_End},
    {"Space", ' ', ImGuiKey_Space},
    {"F1", 290, ImGuiKey_F1},
    {"F2", 291, ImGuiKey_F2},
    {"F3", 292, ImGuiKey_F3},
    {"F4", 293, ImGuiKey_F4},
    {"F5", 294, ImGuiKey_F5},
    {"F6", key::f6, ImGuiKey_F6},
    {"F7", 296, ImGuiKey_F7},
    {"F8", 297, ImGuiKey_F8},
    {"F9", 298, ImGuiKey_F9},
    {"F10", key::f10, ImGuiKey_F10},
    {"F11", 300, ImGuiKey_F11},
    {"F12", 301, ImGuiKey_F12},
    {"KeypadEnter", 335, ImGuiKey_KeypadEnter},
    {"Menu", key::menu, ImGuiKey_Menu},
};

#if NACRE_KEYS_HAVE_NAMES

// Signs have none here: they go by what is typed.
ImGuiKey meaning(int number) {
    if (number >= 'A' && number <= 'Z') return static_cast<ImGuiKey>(ImGuiKey_A + (number - 'A'));
    if (number >= '0' && number <= '9') return static_cast<ImGuiKey>(ImGuiKey_0 + (number - '0'));
    const auto* named = std::ranges::find(named_keys, number, &NamedKey::number);
    return named != std::end(named_keys) ? named->meaning : ImGuiKey_None;
}

#endif

}  // namespace

std::optional<int> named_key(std::string_view name) {
    const auto* named = std::ranges::find(named_keys, name, &NamedKey::name);
    return named != std::end(named_keys) ? std::optional(named->number) : std::nullopt;
}

#if NACRE_KEYS_HAVE_NAMES

void map_keys(ImGuiIO&) {}

void tell_key(ImGuiIO& io, int number, bool down) { io.AddKeyEvent(meaning(number), down); }

void tell_modifiers(ImGuiIO& io, bool ctrl, bool shift, bool alt) {
    io.AddKeyEvent(ImGuiMod_Ctrl, ctrl);
    io.AddKeyEvent(ImGuiMod_Shift, shift);
    io.AddKeyEvent(ImGuiMod_Alt, alt);
}

void tell_pointer(ImGuiIO& io, const ImVec2& pixel) { io.AddMousePosEvent(pixel.x, pixel.y); }
void tell_left_button(ImGuiIO& io, bool down) { io.AddMouseButtonEvent(ImGuiMouseButton_Left, down); }
void tell_wheel(ImGuiIO& io, float notches) { io.AddMouseWheelEvent(0, notches); }

void take_input_at_once(ImGuiIO& io) { io.ConfigInputTrickleEventQueue = false; }

bool input_waits() { return !ImGui::GetCurrentContext()->InputEventsQueue.empty(); }

bool is_key_pressed(int number, bool repeat) {
    const ImGuiKey known = meaning(number);
    return known != ImGuiKey_None && ImGui::IsKeyPressed(known, repeat);
}

bool is_key_down(int number) {
    const ImGuiKey known = meaning(number);
    return known != ImGuiKey_None && ImGui::IsKeyDown(known);
}

void take_key(int number) { ImGui::GetKeyData(meaning(number))->DownDuration = ImGui::GetIO().DeltaTime; }

void lend_tab(bool lent) {
    if (!lent) ImGui::SetKeyOwner(ImGuiKey_Tab, ImHashStr("nacre"));
}

#else

void map_keys(ImGuiIO& io) {
    for (const NamedKey& named : named_keys)
        if (named.meaning != ImGuiKey_None) io.KeyMap[named.meaning] = named.number;
    io.KeyMap[ImGuiKey_A] = 'A';
    io.KeyMap[ImGuiKey_C] = 'C';
    io.KeyMap[ImGuiKey_V] = 'V';
    io.KeyMap[ImGuiKey_X] = 'X';
    io.KeyMap[ImGuiKey_Y] = 'Y';
    io.KeyMap[ImGuiKey_Z] = 'Z';
}

void tell_key(ImGuiIO& io, int number, bool down) { io.KeysDown[number] = down; }

void tell_modifiers(ImGuiIO& io, bool ctrl, bool shift, bool alt) {
    io.KeyCtrl = ctrl;
    io.KeyShift = shift;
    io.KeyAlt = alt;
}

void tell_pointer(ImGuiIO& io, const ImVec2& pixel) { io.MousePos = pixel; }
void tell_left_button(ImGuiIO& io, bool down) { io.MouseDown[ImGuiMouseButton_Left] = down; }
void tell_wheel(ImGuiIO& io, float notches) { io.MouseWheel += notches; }

void take_input_at_once(ImGuiIO&) {}

bool input_waits() { return false; }

bool is_key_pressed(int number, bool repeat) { return ImGui::IsKeyPressed(number, repeat); }

bool is_key_down(int number) { return ImGui::IsKeyDown(number); }

void take_key(int number) { ImGui::GetIO().KeysDownDuration[number] = ImGui::GetIO().DeltaTime; }

void lend_tab(bool lent) { ImGui::GetIO().KeyMap[ImGuiKey_Tab] = lent ? key::tab : -1; }

#endif

}  // namespace nacre::ui
