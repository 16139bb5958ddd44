#include "ui/commands.h"

#include <imgui.h>

#include <cctype>
#include <string_view>

#include "core/base/utf8.h"
#include "ui/item_map.h"
#include "ui/key_press.h"
#include "ui/keys.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace nacre::ui {
namespace {

constexpr CommandInfo list[] = {
    {Command::new_design, "File", "New", "Ctrl+N", nullptr, "A new design, red lacquer.", false},
    {Command::open, "File", "Open\u2026", "Ctrl+O", nullptr, "Open a design from a .nacre file.", false},
    {Command::open_recent, "File", "Open recent", nullptr, nullptr, "Designs used last.", false},
    {Command::save, "File", "Save", "Ctrl+S", nullptr, "Write the design to its file.", true},
    {Command::save_as, "File", "Save as\u2026", "Ctrl+Shift+S", nullptr,
     "Write the design to another file and go on there.", false},
    {Command::export_design, "File", "Export\u2026", "Ctrl+E", nullptr,
     "Write tables, a GLSL function or a picture for other programs.", true},
    {Command::take_picture, "File", "Picture of the preview", "F12", nullptr,
     "Write the preview as a PNG file with the next free number; none is overwritten.", false},
    {Command::picture_folder, "File", "Folder of pictures\u2026", nullptr, nullptr,
     "Choose where F12 writes its pictures.", false},
    {Command::system_dialogs, "File", "Desktop's file dialogs", nullptr, nullptr,
     "Choose files in the desktop's own dialogs, or in Nacre's browser.", true},
    {Command::recover, "File", "Recover unsaved work\u2026", nullptr, nullptr,
     "Work that was not saved when Nacre ended.", false},
    {Command::quit, "File", "Quit", "Ctrl+Q", nullptr, "Asks first where work is unsaved.", true},
    {Command::undo, "Edit", "Undo", "Ctrl+Z", nullptr, "Take back a stroke or a drag.", false},
    {Command::redo, "Edit", "Redo", "Ctrl+Shift+Z", "Ctrl+Y", "Do again what was taken back.", false},
    {Command::show_panels, "View", "Panels", "Tab", nullptr, "Hide the panels and show them again.", false},
    {Command::full_screen, "View", "Full screen", "F11", nullptr, "The window over the whole monitor.",
     false},
    {Command::reset_camera, "View", "Reset camera", nullptr, nullptr, "Back to the first view.", true},
    {Command::show_shortcuts, "Help", "Shortcuts", "F1", nullptr, "All keys and what the mouse does.", false},
    {Command::brush_smaller, "Canvas", nullptr, "[", ",", "A smaller brush.", false},
    {Command::brush_larger, "Canvas", nullptr, "]", ".", "A larger brush.", false},
    {Command::erase, "Canvas", nullptr, "X", nullptr, "Erase, and back to the tool before.", false},
    {Command::choose_layer, "Canvas", nullptr, "1-9", nullptr, "Choose the layer of this number.", false},
};

bool enabled(const MenuState& state, Command command) {
    switch (command) {
        case Command::undo:
            return state.can_undo;
        case Command::redo:
            return state.can_redo;
        case Command::system_dialogs:
            return state.has_system_dialogs;
        case Command::recover:
            return state.can_recover;
        default:
            return true;
    }
}

bool checked(const MenuState& state, Command command) {
    switch (command) {
        case Command::system_dialogs:
            return state.has_system_dialogs && state.uses_system_dialogs;
        case Command::show_panels:
            return state.panels;
        case Command::full_screen:
            return state.full_screen;
        default:
            return false;
    }
}

void recent_menu(const MenuState& state, std::optional<Order>& chosen) {
    const bool open = ImGui::BeginMenu("Open recent", !state.recent.empty());
    note_item("Open recent");
    if (!open) return;
    for (std::size_t i = 0; i < state.recent.size(); ++i) {
        const std::string& path = state.recent[i];
        ImGui::PushID(static_cast<int>(i));
        const std::string name = as_label(path.substr(path.rfind('/') + 1));
        if (ImGui::MenuItem(name.c_str())) chosen = Order(Command::open_recent, i);
        ImGui::PopID();
        note_item("Recent " + std::to_string(i + 1));
        tooltip_for_item(as_utf8(path).c_str());
    }
    ImGui::Separator();
    if (ImGui::MenuItem("Clear the list")) chosen = Command::clear_recent;
    note_item("Clear the list");
    ImGui::EndMenu();
}

void item(const CommandInfo& info, const MenuState& state, std::optional<Order>& chosen) {
    if (info.begins_group) ImGui::Separator();
    if (info.command == Command::open_recent) {
        recent_menu(state, chosen);
        return;
    }
    if (ImGui::MenuItem(info.label, info.keys, checked(state, info.command), enabled(state, info.command)))
        chosen = info.command;
    note_item(info.label);
    tooltip_for_item(info.about);
}

void menu(const char* name, const MenuState& state, std::optional<Order>& chosen) {
    const bool open = ImGui::BeginMenu(name);
    note_item(name);
    if (!open) return;
    for (const CommandInfo& info : list)
        if (info.label != nullptr && std::string_view(info.menu) == name) item(info, state, chosen);
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

// Letters and named keys go by the key, signs by what is typed: many layouts have brackets on AltGr.
bool pressed(const char* keys, bool repeat) {
    if (keys != nullptr && keys[1] == 0 && std::ispunct(static_cast<unsigned char>(keys[0])) != 0)
        return is_typed(keys[0]);
    const auto press = keys != nullptr ? parse_key(keys) : std::nullopt;
    return press && is_pressed(*press, repeat);
}

// While they are held these go on.
bool repeats(Command command) {
    return command == Command::undo || command == Command::redo || command == Command::brush_smaller ||
           command == Command::brush_larger;
}

}  // namespace

std::span<const CommandInfo> all_commands() { return list; }

std::optional<Order> menu_bar(const MenuState& state) {
    std::optional<Order> chosen;
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(scaled(14), scaled(8)));
    if (ImGui::BeginMainMenuBar()) {
        for (const char* name : {"File", "Edit", "View", "Help"}) menu(name, state, chosen);
        title(as_utf8(state.title));
        ImGui::EndMainMenuBar();
    }
    ImGui::PopStyleVar();
    return chosen;
}

void reserve_tab() { lend_tab(ImGui::GetIO().WantTextInput); }

std::optional<Order> pressed_shortcut() {
    if (ImGui::GetIO().WantTextInput || ImGui::IsAnyMouseDown() ||
        ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel))
        return std::nullopt;
    for (const CommandInfo& info : list) {
        if (info.command == Command::choose_layer) {
            for (char digit = '1'; digit <= '9'; ++digit)
                if (is_pressed({.key = digit}, false) || is_typed(digit))
                    return Order(info.command, static_cast<std::size_t>(digit - '1'));
        } else if (pressed(info.keys, repeats(info.command)) || pressed(info.also, repeats(info.command))) {
            return info.command;
        }
    }
    return std::nullopt;
}

}  // namespace nacre::ui
