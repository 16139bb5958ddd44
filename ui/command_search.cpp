#include "ui/command_search.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cctype>
#include <sstream>

#include "ui/dialogs.h"
#include "ui/item_map.h"
#include "ui/keys.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace nacre::ui {
namespace {

constexpr float dialog_ems = 40, list_ems = 24;

std::string in_small_letters(std::string text) {
    for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

// 0 is best; nothing where a word is missing.
std::optional<int> rank(const SearchEntry& entry, const std::string& text) {
    const std::string name = in_small_letters(entry.name);
    const std::string all = name + " " + in_small_letters(entry.where + " " + entry.about);
    std::istringstream words(text);
    for (std::string word; words >> word;)
        if (all.find(word) == all.npos) return {};
    const std::size_t at = name.find(text);
    return at == 0 ? 0 : at != name.npos ? 1 : 2;
}

// Returns whether it was chosen.
bool line(const SearchEntry& entry, bool marked, bool scroll) {
    const std::string label = as_label(entry.name);
    const float width = ImGui::GetContentRegionAvail().x;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const bool chosen =
        ImGui::Selectable(("##" + label).c_str(), marked, ImGuiSelectableFlags_DontClosePopups);
    note_item("Found " + label);
    if (!entry.about.empty()) tooltip_for_item(entry.about.c_str());
    if (marked && scroll) ImGui::SetScrollHereY();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const std::string right = entry.keys.empty() ? entry.where : entry.where + "   " + entry.keys;
    const float far = corner.x + width - ImGui::CalcTextSize(right.c_str()).x - scaled(4);
    const ImVec4 clip(corner.x, corner.y, std::max(far - scaled(8), corner.x),
                      corner.y + ImGui::GetTextLineHeightWithSpacing());
    list.AddText(ImGui::GetFont(), ImGui::GetFontSize(), corner, ImGui::GetColorU32(palette::text),
                 label.c_str(), nullptr, 0, &clip);
    list.AddText({far, corner.y}, ImGui::GetColorU32(palette::text_dim), right.c_str());
    return chosen;
}

}  // namespace

std::vector<std::size_t> found_entries(std::span<const SearchEntry> entries, const std::string& text) {
    const std::string small = in_small_letters(text);
    std::vector<std::pair<int, std::size_t>> ranked;
    for (std::size_t i = 0; i < entries.size(); ++i)
        if (const auto found = rank(entries[i], small)) ranked.emplace_back(*found, i);
    std::stable_sort(ranked.begin(), ranked.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<std::size_t> found;
    for (const auto& [order, index] : ranked) found.push_back(index);
    return found;
}

SearchAnswer command_search(CommandSearch& search, std::span<const SearchEntry> entries) {
    if (!begin_dialog("Find", dialog_ems)) return {};
    const bool appears = ImGui::IsWindowAppearing();
    if (search.take_focus) ImGui::SetKeyboardFocusHere();
    search.take_focus = false;
    ImGui::SetNextItemWidth(-1);
    if (ImGui::InputTextWithHint("##Search", "a command, tool, preset or setting", &search.text))
        search.row = 0;
    // Up and Down stay with it: they go through what was found.
    note_part("Search", ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
    const std::vector<std::size_t> found = found_entries(entries, search.text);
    SearchAnswer answer;
    const std::size_t before = search.row;
    if (is_key_pressed(key::down, true) && search.row + 1 < found.size()) ++search.row;
    if (is_key_pressed(key::up, true) && search.row > 0) --search.row;
    if (!appears && is_key_pressed(key::enter, false) && search.row < found.size())
        answer.chosen = found[search.row];
    ImGui::BeginChild("found", {0, ImGui::GetFontSize() * list_ems});
    for (std::size_t i = 0; i < found.size(); ++i) {
        ImGui::PushID(static_cast<int>(found[i]));
        if (line(entries[found[i]], i == search.row, search.row != before)) answer.chosen = found[i];
        ImGui::PopID();
    }
    if (found.empty()) dim_text("Nothing of that name.");
    ImGui::EndChild();
    // The field has the keyboard, and Escape closes all of it at once.
    answer.closed = answer.chosen || (!appears && is_key_pressed(key::escape, false));
    if (answer.closed) take_key(key::escape);
    end_dialog(answer.closed);
    return answer;
}

}  // namespace nacre::ui
