#include "ui/escape.h"

#include <imgui.h>
#include <imgui_internal.h>

#include "ui/keys.h"

namespace nacre::ui {
namespace {

int taken_back = -1;         // the frame
bool pointer_rests = false;  // on the entry of a menu that was closed: it opens by being pointed at

}  // namespace

bool escape_pressed() { return !ImGui::GetIO().WantTextInput && is_key_pressed(key::escape, false); }

bool take_escape() {
    if (!escape_pressed()) return false;
    take_key(key::escape);
    return true;
}

bool take_escape_of_drag() {
    if (ImGui::GetFrameCount() < taken_back) taken_back = -1;  // of a window before this one
    if (!ImGui::IsAnyItemActive() || !ImGui::IsAnyMouseDown() || !take_escape()) return false;
    ImGui::ClearActiveID();
    taken_back = ImGui::GetFrameCount();
    return true;
}

bool drag_taken_back() { return taken_back == ImGui::GetFrameCount(); }

void close_popup_by_escape() {
    taken_back = -1;
    ImGuiContext& context = *ImGui::GetCurrentContext();
    const ImVector<ImGuiPopupData>& open = context.OpenPopupStack;
    const ImVec2 moved = ImGui::GetIO().MouseDelta;
    pointer_rests &= !open.empty() && moved.x == 0 && moved.y == 0 && !ImGui::IsAnyMouseDown();
    if (pointer_rests) context.NavDisableMouseHover = true;
    if (open.empty() || ImGui::IsAnyMouseDown()) return;
    const ImGuiWindow* top = open.back().Window;
    if (top == nullptr || (top->Flags & ImGuiWindowFlags_Modal) != 0 || !take_escape()) return;
    pointer_rests = context.NavDisableMouseHover = (top->Flags & ImGuiWindowFlags_ChildMenu) != 0;
    ImGui::ClosePopupToLevel(open.Size - 1, true);
}

}  // namespace nacre::ui
