#include "app/headless/input.h"

#include "ui/keys.h"

namespace nacre {
namespace {

// What the key types on a US keyboard; Shift makes letters of letters, other signs have keys of their own
// here.
void type(ImGuiIO& io, const ui::KeyPress& press) {
    const bool letter = press.key >= 'A' && press.key <= 'Z', prints = press.key >= ' ' && press.key <= '~';
    if (!prints || press.ctrl || press.alt || (press.shift && !letter)) return;
    io.AddInputCharacter(static_cast<unsigned>(letter && !press.shift ? press.key - 'A' + 'a' : press.key));
}

}  // namespace

void set_key(ImGuiIO& io, const ui::KeyPress& press, bool down) {
    ui::tell_key(io, press.key, down);
    ui::tell_modifiers(io, down && press.ctrl, down && press.shift, down && press.alt);
    if (down) type(io, press);
}

}  // namespace nacre
