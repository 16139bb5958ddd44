#include "ui/shortcut_sheet.h"

#include <imgui.h>

#include <algorithm>
#include <string_view>

#include "ui/canvas_tools.h"
#include "ui/dialogs.h"
#include "ui/escape.h"
#include "ui/key_press.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace nacre::ui {
namespace {

constexpr float width_ems = 81;
constexpr float line_gap = 2;  // between two lines

SheetGroup keyboard_group() {
    return {"Keyboard",
            {{"Down, Up", "To the next widget of this part of the window, or the one before."},
             {"F6, Shift+F6", "To the next part, or the one before."},
             {"F10", "To the menus."},
             {"Enter or Space", "Clicks, or types into a number; brings a pointer to the canvas or preview."},
             {"Arrows, with a pointer", "Move it; with Shift by one pixel."},
             {"Enter, Space, with it", "Clicks; presses, and lets go the next time."},
             {"Page Up, Down, with it", "Closer and farther."},
             {"Left, Right", "A number less or more; with Shift a tenth of that."},
             {"Shift+F10 or Menu", "What a right click opens."}}};
}

SheetGroup mouse_group() {
    return {"Mouse",
            {{"Drag on the preview", "Moves the highlight: the light follows."},
             {"Shift+drag there", "The same while a brush is in hand."},
             {"Right drag there", "Turns the object."},
             {"Drag on the canvas", "Pulls a handle or paints with the tool."},
             {"Right drag there", "Turns the dome, or moves the disk."},
             {"Shift+drag there", "With a brush: sizes it."},
             {"Shift+click there", "A line from where the last stroke ended."},
             {"Ctrl or Alt+click", "With a brush: picks the value that is there."},
             {"Shift+drag, selecting", "Adds to what is selected; Ctrl or Alt takes away."},
             {"Wheel", "Closer and farther, canvas and preview."},
             {"Double click", "On a number or its label: its usual value."},
             {"Ctrl+click", "On a number: type it."},
             {"Escape", "Closes what is on top, takes a drag back."},
             {"Drop a file", "A .nacre or .obj file opens; a picture asks."}}};
}

std::string keys_text(const CommandInfo& info) {
    std::string text = info.keys;
    if (info.also != nullptr) text += std::string(" or ") + info.also;
    return text;
}

SheetGroup& group(std::vector<SheetGroup>& groups, std::string_view title) {
    const auto found =
        std::find_if(groups.begin(), groups.end(), [&](const SheetGroup& g) { return g.title == title; });
    if (found != groups.end()) return *found;
    groups.push_back({std::string(title), {}});
    return groups.back();
}

float keys_width(const SheetGroup& shown) {
    float most = 0;
    for (const SheetLine& line : shown.lines) most = std::max(most, ImGui::CalcTextSize(line.keys.c_str()).x);
    return most + ImGui::GetFontSize() * 0.8f;
}

void draw_group(const SheetGroup& shown) {
    heading(shown.title.c_str());
    const float keys = keys_width(shown), left = ImGui::GetCursorPosX();
    for (const SheetLine& line : shown.lines) {
        ImGui::PushStyleColor(ImGuiCol_Text, palette::accent_bright);
        ImGui::TextUnformatted(line.keys.c_str());
        ImGui::PopStyleColor();
        ImGui::SameLine();
        ImGui::SetCursorPosX(left + keys);
        ImGui::TextWrapped("%s", line.about.c_str());
    }
    ImGui::Spacing();
    ImGui::Spacing();
}

// The columns: the document and the window, the canvas, keyboard and mouse.
void draw_groups(const std::vector<SheetGroup>& groups) {
    if (!ImGui::BeginTable("groups", 3)) return;
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(gap, scaled(line_gap)));
    ImGui::TableNextRow();
    for (const SheetGroup& shown : groups) {
        if (shown.title == "File" || shown.title == "Canvas" || shown.title == "Keyboard")
            ImGui::TableNextColumn();
        draw_group(shown);
    }
    ImGui::PopStyleVar();
    ImGui::EndTable();
}

}  // namespace

std::vector<SheetGroup> shortcut_groups(CommandInfos commands) {
    std::vector<SheetGroup> groups;
    // What concerns the canvas stands after what concerns the document.
    const auto add_commands = [&](bool selecting) {
        for (const CommandInfo* info : commands)
            if (info->keys != nullptr && (std::string_view(info->menu) == "Select") == selecting)
                group(groups, info->menu).lines.push_back({keys_text(*info), info->about});
    };
    add_commands(false);
    for (const ToolEntry& entry : canvas_tools())
        group(groups, "Tools")
            .lines.push_back(
                {std::string(1, entry.face->key), std::string(entry.face->name) + ". " + entry.face->about});
    add_commands(true);
    groups.push_back(keyboard_group());
    groups.push_back(mouse_group());
    return groups;
}

bool shortcut_sheet(CommandInfos commands, const char* opened_by) {
    if (!begin_dialog("Shortcuts", width_ems)) return true;
    draw_groups(shortcut_groups(commands));
    const float width = ImGui::GetFontSize() * 7;
    ImGui::SetCursorPosX(ImGui::GetContentRegionMax().x - width);
    bool closed = button("Close", nullptr, true, width);
    // `opened_by` is still down in its first frame.
    if (!ImGui::IsWindowAppearing())
        for (const char* key : {"Enter", opened_by}) closed |= is_pressed(*parse_key(key), false);
    closed |= take_escape();
    end_dialog(closed);
    return !closed;
}

std::string shortcuts_markdown(CommandInfos commands) {
    std::string text;
    for (const SheetGroup& shown : shortcut_groups(commands)) {
        text += "| " + shown.title + " | |\n| --- | --- |\n";
        for (const SheetLine& line : shown.lines) text += "| " + line.keys + " | " + line.about + " |\n";
        text += '\n';
    }
    return text;
}

}  // namespace nacre::ui
