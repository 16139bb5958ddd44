#include "ui/commands.h"

#include <imgui.h>

#include <algorithm>
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

// The menu bar while it is drawn.
class MenuBar {
  public:
    explicit MenuBar(std::span<const CommandState> commands) : commands_(commands) {}

    void draw() {
        std::vector<std::string_view> drawn;
        for (const CommandState& command : commands_) {
            const std::string_view path = command.info->menu;
            const std::string_view name = path.substr(0, path.find('/'));
            if (command.info->label == nullptr || std::find(drawn.begin(), drawn.end(), name) != drawn.end())
                continue;
            drawn.push_back(name);
            menu(name, true);
        }
    }

    std::optional<Order> chosen() const { return chosen_; }

  private:
    void menu(std::string_view path, bool enabled) {
        const std::string name(path.substr(path.rfind('/') + 1));
        const bool open = ImGui::BeginMenu(name.c_str(), enabled);
        note_item(name);
        if (!open) return;
        std::string_view within;  // the menu in this one that was drawn last
        for (std::size_t i = 0; i < commands_.size(); ++i) {
            const std::string_view at = commands_[i].info->menu;
            if (commands_[i].info->label == nullptr || !at.starts_with(path)) continue;
            if (at == path) {
                item(i);
            } else if (at != within) {
                within = at;
                menu(at, any_enabled(at));
            }
        }
        ImGui::EndMenu();
    }

    bool any_enabled(std::string_view path) const {
        return std::any_of(commands_.begin(), commands_.end(), [&](const CommandState& command) {
            return command.info->menu == path && command.enabled;
        });
    }

    void item(std::size_t index) {
        const CommandState& command = commands_[index];
        const CommandInfo& info = *command.info;
        if (info.begins_group) ImGui::Separator();
        if (command.choices) return choices(index);
        if (ImGui::MenuItem(info.label, info.keys, command.checked, command.enabled)) chosen_ = Order{index};
        note_item(info.label);
        tooltip_for_item(info.about);
    }

    void choices(std::size_t index) {
        const std::vector<CommandChoice>& choices = *commands_[index].choices;
        for (std::size_t i = 0; i < choices.size(); ++i) {
            ImGui::PushID(static_cast<int>(i));
            if (ImGui::MenuItem(as_label(choices[i].label).c_str())) chosen_ = Order{index, i};
            ImGui::PopID();
            note_item(std::string(commands_[index].info->label) + " " + std::to_string(i + 1));
            tooltip_for_item(as_utf8(choices[i].about).c_str());
        }
    }

    std::span<const CommandState> commands_;
    std::optional<Order> chosen_;
};

void draw_title(const std::string& text) {
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

// Which of the digits 1 to 9, from 0.
std::optional<std::size_t> pressed_digit() {
    for (char digit = '1'; digit <= '9'; ++digit)
        if (is_pressed({.key = digit}, false) || is_typed(digit))
            return static_cast<std::size_t>(digit - '1');
    return std::nullopt;
}

}  // namespace

std::optional<Order> menu_bar(std::span<const CommandState> commands, const std::string& title) {
    MenuBar bar(commands);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(scaled(14), scaled(8)));
    if (ImGui::BeginMainMenuBar()) {
        bar.draw();
        draw_title(as_utf8(title));
        ImGui::EndMainMenuBar();
    }
    ImGui::PopStyleVar();
    return bar.chosen();
}

void reserve_tab() { lend_tab(ImGui::GetIO().WantTextInput); }

std::optional<Order> pressed_shortcut(CommandInfos commands) {
    if (ImGui::GetIO().WantTextInput || ImGui::IsAnyMouseDown() ||
        ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel))
        return std::nullopt;
    for (std::size_t i = 0; i < commands.size(); ++i) {
        const CommandInfo& info = *commands[i];
        if (info.keys != nullptr && std::string_view(info.keys) == nine_digits) {
            if (const auto digit = pressed_digit()) return Order{i, *digit};
        } else if (pressed(info.keys, info.repeats) || pressed(info.also, info.repeats)) {
            return Order{i};
        }
    }
    return std::nullopt;
}

}  // namespace nacre::ui
