#include "ui/commands.h"

#include <imgui.h>

#include "ui/item_map.h"
#include "ui/theme.h"

namespace nacre::ui {
namespace {

struct Shortcut {
    char key;
    bool shift;
    Command command;
};

constexpr Shortcut shortcuts[] = {
    {'N', false, Command::new_design}, {'O', false, Command::open}, {'S', false, Command::save},
    {'S', true, Command::save_as},     {'Z', false, Command::undo}, {'Z', true, Command::redo},
    {'Y', false, Command::redo},       {'Q', false, Command::quit},
};

void item(const char* label, const char* keys, Command command, bool enabled,
          std::optional<Command>& chosen) {
    if (ImGui::MenuItem(label, keys, false, enabled)) chosen = command;
    note_item(label);
}

void file_menu(std::optional<Command>& chosen) {
    const bool open = ImGui::BeginMenu("File");
    note_item("File");
    if (!open) return;
    item("New", "Ctrl+N", Command::new_design, true, chosen);
    item("Open\u2026", "Ctrl+O", Command::open, true, chosen);
    ImGui::Separator();
    item("Save", "Ctrl+S", Command::save, true, chosen);
    item("Save as\u2026", "Ctrl+Shift+S", Command::save_as, true, chosen);
    ImGui::Separator();
    item("Quit", "Ctrl+Q", Command::quit, true, chosen);
    ImGui::EndMenu();
}

void edit_menu(const MenuState& state, std::optional<Command>& chosen) {
    const bool open = ImGui::BeginMenu("Edit");
    note_item("Edit");
    if (!open) return;
    item("Undo", "Ctrl+Z", Command::undo, state.can_undo, chosen);
    item("Redo", "Ctrl+Shift+Z", Command::redo, state.can_redo, chosen);
    ImGui::EndMenu();
}

void view_menu(std::optional<Command>& chosen) {
    const bool open = ImGui::BeginMenu("View");
    note_item("View");
    if (!open) return;
    item("Reset camera", nullptr, Command::reset_camera, true, chosen);
    ImGui::EndMenu();
}

void title(const std::string& text) {
    const float width = ImGui::CalcTextSize(text.c_str()).x;
    const float left = ImGui::GetWindowWidth() - width - ImGui::GetStyle().WindowPadding.x;
    if (left > ImGui::GetCursorPosX()) ImGui::SetCursorPosX(left);
    ImGui::PushStyleColor(ImGuiCol_Text, palette::text_dim);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopStyleColor();
}

}  // namespace

std::optional<Command> menu_bar(const MenuState& state) {
    std::optional<Command> chosen;
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(scaled(14), scaled(8)));
    if (ImGui::BeginMainMenuBar()) {
        file_menu(chosen);
        edit_menu(state, chosen);
        view_menu(chosen);
        title(state.title);
        ImGui::EndMainMenuBar();
    }
    ImGui::PopStyleVar();
    return chosen;
}

std::optional<Command> pressed_shortcut() {
    const ImGuiIO& io = ImGui::GetIO();
    if (!io.KeyCtrl || io.KeyAlt || io.WantTextInput || ImGui::IsAnyMouseDown()) return std::nullopt;
    for (const Shortcut& shortcut : shortcuts)
        if (shortcut.shift == io.KeyShift && ImGui::IsKeyPressed(shortcut.key)) return shortcut.command;
    return std::nullopt;
}

}  // namespace nacre::ui
