#include "app/designer/other_side.h"

#include <imgui.h>

#include "app/designer/command.h"
#include "ui/key_press.h"
#include "ui/keys.h"

namespace nacre {
namespace {

constexpr double tap_seconds = 0.3;

bool key_is_down() {
    const auto press = ui::parse_key(show_other_command.info.keys);
    return press && ui::is_key_down(press->key);
}

}  // namespace

void toggle_other_side(Designer& designer) {
    Comparison& comparison = designer.comparison;
    if (comparison.shows_other())
        comparison.show_present();
    else if (comparison.show_other(designer.frame.design))
        designer.other_since = ImGui::GetTime();
    else
        designer.files.tell("Nothing to compare with yet: take a snapshot in Compare");
}

void follow_held_key(Designer& designer) {
    if (!designer.other_since || key_is_down()) return;
    if (ImGui::GetTime() - *designer.other_since > tap_seconds) designer.comparison.show_present();
    designer.other_since.reset();
}

}  // namespace nacre
